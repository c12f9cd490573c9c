#each light
#if light.varying_distance && light.many
    for (int i = 0; i < ${light.end}; ++i) {
        ${light.v}_distance[i] = length(${light.uniform}.position - P); // Fault: not the distance of the point between.
    }
#elif light.varying_distance
    ${light.v}_distance[0] = length(${light.uniform}.position - P); // Fault: not the distance of the point between.
#endif
#if light.varying_attenuation && light.many
    for (int i = 0; i < ${light.end}; ++i) {
        float d = length(${light.uniform}.position - P);
        ${light.v}_attenuation[i] = 1.0 / ${light.safe_denominator}; // Fault: not linear between vertices.
    }
#elif light.varying_attenuation
    {
        float d = length(${light.uniform}.position - P);
        ${light.v}_attenuation[0] = 1.0 / ${light.safe_denominator}; // Fault: not linear between vertices.
    }
#endif
#end
