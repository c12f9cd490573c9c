    float c = dot(-L, light.direction);
#if spot.soft_cone && spot.hard_cone
    float s = light.cos_inner_cutoff > light.cos_cutoff
        ? smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c)
        : (c < light.cos_cutoff ? 0.0 : 1.0);
#elif spot.soft_cone
    float s = smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c);
#else
    float s = c < light.cos_cutoff ? 0.0 : 1.0;
#endif
#if spot.stable_exponent
    vec3 sine = cross(L, light.direction); // its square is 1 - c^2
    float falloff = c > 0.0 ? stable_power(dot(sine, sine), 0.5 * light.exponent) : 0.0;
#elif spot.exponent
    float falloff = pow(max(c, 0.0), light.exponent);
#endif
#if spot.exponent && spot.no_exponent
    s *= light.exponent > 0.0 ? falloff : 1.0;
#elif spot.exponent
    s *= falloff;
#endif
