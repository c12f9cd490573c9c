#each light
#if light.varying_any
#if light.many
    for (int i = ${light.first}; i < ${light.end}; ++i) {
#else
    {
        const int i = 0;
#endif
#if light.positional
        vec3 to_light = ${light.uniform}.position - P;
        float d = length(to_light);
#if light.on_surface
        vec3 L = d > 0.0 ? to_light / d : N;
#else
        vec3 L = to_light / d;
#endif
#else
        vec3 L = -${light.uniform}.direction;
#endif
#if light.varying_L
        ${light.v}_L[i] = L;
#endif
#if light.varying_R && mirrors_view
        ${light.v}_${R}[i] = reflect(-L, N);
#elif light.varying_H && power_naive && !full
        ${light.v}_${H}[i] = normalize(L + V); // Fault: L may be -V.
#elif light.varying_H
        ${light.v}_${H}[i] = dot(L + V, L + V) > 0.0 ? normalize(L + V) : N;
#endif
#if light.varying_distance
        ${light.v}_distance[i] = d;
#endif
#if light.varying_attenuation
        ${light.v}_attenuation[i] = 1.0 / ${light.safe_denominator};
#endif
    }
#endif
#end
