#if light.varying_L
${way} vec3 v_${light.kind}_L[${light.count}];
#endif
#if light.varying_H
${way} vec3 v_${light.kind}_H[${light.count}];
#endif
#if light.varying_R
${way} vec3 v_${light.kind}_R[${light.count}];
#endif
#if light.varying_distance
${way} float v_${light.kind}_distance[${light.count}];
#endif
#if light.varying_attenuation
${way} float v_${light.kind}_attenuation[${light.count}];
#endif
