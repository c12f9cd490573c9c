#if light.uses_n_dot_l
    float n_dot_l = dot(N, L);
#endif
#if light.adds_specular && full
    bool open = gate_none || (gate_view_facing ? dot(N, V) : n_dot_l) > 0.0;
    float highlight = open ? ${light.highlight} : 0.0;
#if gate_times_n_dot_l
    highlight *= n_dot_l; // Fault: dims the highlight, and not only at its edge.
#endif
#elif light.adds_specular && gate_light_facing
    float highlight = n_dot_l > 0.0 ? ${light.highlight} : 0.0;
#elif light.adds_specular && gate_view_facing
    float highlight = dot(N, V) > 0.0 ? ${light.highlight} : 0.0; // Fault: asks whether the viewer is in front, not the light.
#elif light.adds_specular && gate_times_n_dot_l
    float highlight = max(n_dot_l, 0.0) * ${light.highlight}; // Fault: dims the highlight, and not only at its edge.
#elif light.adds_specular
    float highlight = ${light.highlight}; // Fault: shines through from behind.
#endif
#if light.adds_ambient || light.adds_attenuated_ambient
#if ambient_where_lit
    float lit = n_dot_l > 0.0 ? 1.0 : 0.0; // Fault: ambient light needs no facing.
#elif full
    float lit = 1.0;
#endif
#endif
#if light.adds_specular && full
    vec3 shine = ${light.shine};
#endif
#if light.adds_separate_specular && full
    specular += specular_apart ? ${light.specular_sum} : vec3(0.0);
#elif light.adds_separate_specular
    specular += ${light.specular_sum};
#endif
    return ${light.sum};
