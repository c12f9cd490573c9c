#if vertex.lit
${flat}${way} vec3 v_light;
#endif
#if vertex.separate_specular
${flat}${way} vec3 v_specular;
#endif
#if both_sides
${flat}${way} vec3 v_back_light;
#endif
#if both_sides && vertex.separate_specular
${flat}${way} vec3 v_back_specular;
#endif
#if fragment.P && own
${way} vec3 v_position; // world space
#elif fragment.P && !wide
${way} vec3 v_position; // from the eye
#endif
#if fragment.N
${way} vec3 v_normal;
#endif
#if passes_view
${way} vec3 v_view;
#endif
#each array
#if array.varying_L
${way} vec3 ${array.v}_L[${array.count}];
#endif
#if array.varying_H
${way} vec3 ${array.v}_${H}[${array.count}];
#endif
#if array.varying_R
${way} vec3 ${array.v}_${R}[${array.count}];
#endif
#if array.varying_distance
${way} float ${array.v}_distance[${array.count}];
#endif
#if array.varying_attenuation
${way} float ${array.v}_attenuation[${array.count}];
#endif
#end
#if reads_uv
${way} vec2 v_uv;
#endif
#if reads_checker
${way} vec3 v_object_position;
#endif
#if reads_color
${way} vec3 v_color;
#endif
