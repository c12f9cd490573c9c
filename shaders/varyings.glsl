#if vertex.lit
${flat}${way} vec3 v_light;
#endif
#if vertex.separate_specular
${flat}${way} vec3 v_specular;
#endif
#if fragment.P && !wide
${way} vec3 v_position; // from the eye
#endif
#if fragment.N
${way} vec3 v_normal;
#endif
#if vectors && fragment.V && !viewer_infinite
${way} vec3 v_view;
#endif
#include "varyings_light.glsl" with directional
#include "varyings_light.glsl" with point
#include "varyings_light.glsl" with spot
#if texture
${way} vec2 v_uv;
#endif
#if checker
${way} vec3 v_object_position;
#endif
