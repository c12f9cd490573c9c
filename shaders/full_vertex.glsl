#version 330 core

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_uv;
#if flat
layout(location = 3) in vec3 a_centroid;
#endif

#include "full_varyings.glsl"

uniform mat4 model_view_projection;
uniform mat4 model; // world space, moved so that the eye is the origin
uniform mat3 normal_matrix; // inverse transpose of model
uniform vec3 eye;
uniform vec3 view_direction; // towards a viewer at infinity
uniform bool position_w0;
#if vertex_lit
uniform bool two_sided;
#endif
uniform int normal_transform; // 0 identity, 1 rigid, 2 normal matrix, 3 model matrix, 4 untransformed

#if vertex_lit || vectors
#include "full_lighting.glsl"
#else
uniform bool viewer_infinite;
#endif

#include "math_unit.glsl"

vec3 surface_normal()
{
    if (normal_transform < 2 || normal_transform == 4) {
        return normal_transform == 1 ? mat3(model) * a_normal : a_normal;
    }
    return guarded_unit(normal_transform == 2 ? normal_matrix * a_normal : mat3(model) * a_normal, a_normal);
}

void main()
{
    gl_Position = model_view_projection * vec4(a_position, 1.0);
    vec4 point = vec4(${full.point}, position_w0 ? 0.0 : 1.0);
    vec3 P = (model * point).xyz - (position_w0 ? eye : vec3(0.0));
    vec3 N = surface_normal();
    vec3 V = viewer_infinite ? view_direction : -P / max(length(P), 1e-18);
#if fragment_lit
    v_normal = N;
#endif
#if vertex_lit
    N = two_sided && dot(N, V) < 0.0 ? -N : N;
    v_light = ambient;
#if hybrid
    vec3 specular = vec3(0.0); // per pixel
    add_all_lights(P, N, V, true, v_light, specular);
#else
    v_specular = vec3(0.0);
    add_all_lights(P, N, V, true, v_light, v_specular);
#endif
#endif
#if vectors
    v_view = V;
    for (int i = 0; i < light_count; ++i) {
        vec3 to_light = lights[i].position - P;
        vec3 L = direction_to_light(lights[i], to_light, N);
        v_L[i] = L;
        v_distance[i] = length(to_light);
        if (model_kind == 1) {
            v_reflection[i] = reflect(-L, N);
        } else {
            vec3 H = half_vector(lights[i], L, V);
            v_reflection[i] = H != vec3(0.0) ? normalize(H) : N;
        }
    }
    for (int i = light_count; i < ${full.lights}; ++i) {
        v_L[i] = v_reflection[i] = N;
        v_distance[i] = 0.0;
    }
#endif
#if fragment_lit && !vectors && !wide
    v_position = P;
#endif
    v_object_position = a_position;
    v_uv = a_uv;
}
