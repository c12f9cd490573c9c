#if vertex_lit
${flat}${way} vec3 v_light;
#endif
#if vertex_lit && !hybrid
${flat}${way} vec3 v_specular;
#endif
#if fragment_lit
${way} vec3 v_normal;
#endif
#if fragment_lit && !vectors && !wide
${way} vec3 v_position; // from the eye
#endif
#if vectors
${way} vec3 v_view;
${way} vec3 v_L[${full.lights}];
${way} vec3 v_reflection[${full.lights}]; // H, or R under Phong
${way} float v_distance[${full.lights}];
#endif
${way} vec3 v_object_position;
${way} vec2 v_uv;
