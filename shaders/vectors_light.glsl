#if light.varying_any && light.many
    for (int i = 0; i < ${light.count}; ++i) {
#elif light.varying_any
    {
        const int i = 0;
#endif
#if light.varying_any && light.positional
        vec3 to_light = ${light.uniform}.position - P;
        float d = length(to_light);
#if light.on_surface
        vec3 L = d > 0.0 ? to_light / d : N;
#else
        vec3 L = to_light / d;
#endif
#elif light.varying_any
        vec3 L = -${light.uniform}.direction;
#endif
#if light.varying_L
        v_${light.kind}_L[i] = L;
#endif
#if light.varying_H
        v_${light.kind}_H[i] = dot(L + V, L + V) > 0.0 ? normalize(L + V) : N;
#endif
#if light.varying_R
        v_${light.kind}_R[i] = reflect(-L, N);
#endif
#if light.varying_distance
        v_${light.kind}_distance[i] = d;
#endif
#if light.varying_attenuation
        v_${light.kind}_attenuation[i] = 1.0 / ${light.safe_denominator};
#endif
#if light.varying_any
    }
#endif
