#version 330 core

#include "full_varyings.glsl"
layout(location = 0) out vec4 color;
#if object_ids
layout(location = 1) out uint id;

uniform uint object_id;
#endif
#if wide
uniform vec3 ray_corner; // where the picture's lower left corner looks, to a depth of 1
uniform vec3 ray_right; // a pixel further
uniform vec3 ray_up;
#endif
#if deep
uniform float depth_per_octave;
uniform float depth_at_1;
#endif

#if fragment_lit
uniform vec3 view_direction; // towards a viewer at infinity
uniform bool renormalize;
uniform bool two_sided;
#include "full_lighting.glsl"
#endif
#if hybrid
uniform bool specular_times_base;
#endif
uniform vec3 emission;
uniform int base_kind; // 0 none, 1 texture, 2 checker
uniform sampler2D base_texture;
#include "base_checker.glsl"

vec3 base_color()
{
    if (base_kind == 1) {
        return texture(base_texture, v_uv).rgb;
    }
    if (base_kind == 2) {
        return checker_color(v_object_position);
    }
    return vec3(1.0);
}

#if vectors
// N, L, H (or R) and the distance as interpolated; made unit again, the distance as it is.
void add_all_vectors(vec3 N, vec3 V, inout vec3 multiplied, inout vec3 specular)
{
    for (int i = 0; i < light_count; ++i) {
        vec3 L = lights[i].type == 0 ? -lights[i].direction : normalize(v_L[i]);
        float highlight = 0.0;
        if (model_kind == 1) {
            highlight = phong(normalize(v_reflection[i]), V, true);
        } else if (model_kind == 2) {
            highlight = blinn_phong(N, v_reflection[i], renormalize);
        }
        add_light(lights[i], N, V, L, v_distance[i], highlight, multiplied, specular);
    }
}
#endif

void main()
{
#if vertex_lit
    vec3 multiplied = v_light;
#else
    vec3 multiplied = ambient;
#endif
#if vertex_lit && !hybrid
    vec3 specular = v_specular;
#else
    vec3 specular = vec3(0.0);
#endif
#if fragment_lit
    vec3 N = renormalize && v_normal != vec3(0.0) ? normalize(v_normal) : v_normal;
#if vectors
    vec3 V = viewer_infinite ? view_direction : normalize(v_view);
#elif wide
    vec3 P = (ray_corner + gl_FragCoord.x * ray_right + gl_FragCoord.y * ray_up) / gl_FragCoord.w; // interpolation over so wide a surface loses digits
    vec3 V = viewer_infinite ? view_direction : normalize(-P);
#else
    vec3 P = v_position;
    vec3 V = viewer_infinite ? view_direction : normalize(-P);
#endif
    N = two_sided && dot(N, V) < 0.0 ? -N : N;
#endif
#if vectors
    add_all_vectors(N, V, multiplied, specular);
#elif hybrid
    vec3 diffuse = vec3(0.0); // per vertex
    add_all_lights(P, N, V, renormalize, diffuse, specular);
#elif fragment_lit
    add_all_lights(P, N, V, renormalize, multiplied, specular);
#endif
    vec3 base = base_color();
#if hybrid
    specular *= specular_times_base ? base : vec3(1.0);
#endif
    color = vec4(base * multiplied + specular + emission, 1.0);
#if object_ids
    id = object_id;
#endif
#if deep
    // Near and far are too far apart for z / w; gl_FragCoord.w is 1 / distance.
    gl_FragDepth = depth_at_1 - depth_per_octave * log2(gl_FragCoord.w);
    if (gl_FragDepth < 0.0 || gl_FragDepth > 1.0) {
        discard; // before near, beyond far: z is too coarse to clip by
    }
#endif
}
