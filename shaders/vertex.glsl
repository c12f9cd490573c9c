#version 330 core

layout(location = 0) in vec3 a_position;
#if reads_normal
layout(location = 1) in vec3 a_normal;
#endif
#if reads_uv
layout(location = 2) in vec2 a_uv;
#endif
#if reads_centroid
layout(location = 3) in vec3 a_centroid;
#endif
#if reads_color
layout(location = 4) in vec3 a_color;
#endif

#include "varyings.glsl"

#choices

#if invariant
invariant gl_Position; // two programs draw triangles that share edges
#endif
uniform mat4 model_view_projection;
#if own.at_vertices
#include "own_shading.glsl"
#endif
#include "surface_vertex.glsl"
#if vertex.lit && !own
#include "lighting.glsl"
#elif vertex.declares_lights
#include "lights.glsl"
#endif
#if vertex.uses_view_direction && !vertex.lit
uniform vec3 view_direction; // towards a viewer at infinity
#endif

void main()
{
    gl_Position = model_view_projection * vec4(a_position, 1.0);
#if vertex.P
    vec3 P = surface_position();
#endif
#if vertex.N
    vec3 N = surface_normal();
#endif
#if fragment.N
    v_normal = N;
#endif
#if vertex.V && viewer_infinite
    vec3 V = view_direction;
#elif vertex.V && off_eye && power_naive && !full
    vec3 V = normalize(eye - P);
#elif vertex.V && off_eye
    vec3 V = (eye - P) / max(length(eye - P), 1e-18); // a vertex may lie at the eye
#elif vertex.V && power_naive && !full
    vec3 V = normalize(-P); // Fault: a vertex may lie at the eye.
#elif vertex.V
    vec3 V = -P / max(length(P), 1e-18); // a vertex may lie at the eye
#endif
#if vertex.lit && vertex.N && vertex.V && two_sided && facing_view
    N = dot(N, V) < 0.0 ? -N : N; // Fault: where an interpolated N leans away, no back is seen.
#endif
#if vertex.separate_specular && !own
    v_specular = vec3(0.0);
#endif
#if own.apart
    own_base = vec3(0.0); // what no base colour multiplies; the rest is proportional to it
    v_specular = lighting(${vertex.surface_arguments});
    own_base = vec3(1.0);
    v_light = lighting(${vertex.surface_arguments}) - v_specular;
#elif vertex.lit
    v_light = lighting(${vertex.surface_arguments});
#endif
#if own.apart && both_sides
    own_base = vec3(0.0);
    v_back_specular = lighting(${vertex.back_arguments});
    own_base = vec3(1.0);
    v_back_light = lighting(${vertex.back_arguments}) - v_back_specular;
#elif both_sides && two_sided && facing_winding
#if vertex.separate_specular
    v_back_specular = vec3(0.0);
#endif
    v_back_light = lighting(${vertex.back_arguments});
#endif
#if vectors
#include "vectors_vertex.glsl"
#else
#include "attenuation_vertex.glsl"
#endif
#if fragment.P && !wide
    v_position = P;
#endif
#if passes_view
    v_view = V;
#endif
#if reads_uv
    v_uv = a_uv;
#endif
#if reads_checker
    v_object_position = a_position;
#endif
#if reads_color
    v_color = a_color;
#endif
}
