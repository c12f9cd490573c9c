    float c = dot(-L, light.direction);
#if full || light.narrow_cone || light.stable_exponent
    vec3 sine = cross(L, light.direction); // its square is 1 - c^2
#endif
#if light.narrow_cone
    // How far inside the cone: c - cos_cutoff, found from the sines where cosines near 1 have no digits left.
    float inside = c > 0.5 ? (light.sin2_cutoff - dot(sine, sine)) / (c + light.cos_cutoff) : c - light.cos_cutoff;
#if light.soft_cone && light.hard_cone
    float s = light.edge_sharpness > 0.0
        ? smoothstep(0.0, 1.0, inside * light.edge_sharpness)
        : (inside < 0.0 ? 0.0 : 1.0);
#elif light.soft_cone
    float s = smoothstep(0.0, 1.0, inside * light.edge_sharpness);
#else
    float s = inside < 0.0 ? 0.0 : 1.0;
#endif
#elif light.soft_cone && light.hard_cone
    float s = light.cos_inner_cutoff > light.cos_cutoff
        ? smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c)
        : (c < light.cos_cutoff ? 0.0 : 1.0);
#elif light.soft_cone
    float s = smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c);
#else
    float s = c < light.cos_cutoff ? 0.0 : 1.0;
#endif
#if light.stable_exponent
    float falloff = c > 0.0 ? stable_power(dot(sine, sine), 0.5 * light.exponent) : 0.0;
#elif light.exponent
    float falloff = pow(max(c, 0.0), light.exponent);
#endif
#if light.exponent && light.no_exponent
    s *= light.exponent > 0.0 ? falloff : 1.0;
#elif light.exponent
    s *= falloff;
#endif
