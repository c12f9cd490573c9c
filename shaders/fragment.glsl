#version 330 core
#if mediump
precision mediump float; // as precise as this device likes
#endif

#if precision_medium && !full
#include "math_half.glsl"
#endif
#include "varyings.glsl"
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

#choices

#if fragment.reads_eye
uniform vec3 eye;
#endif

#if own.pixels
#include "own_shading.glsl"
#elif fragment.lit
#include "lighting.glsl"
#elif fragment.constant_ambient
uniform vec3 ambient; // all constant ambient light, times the material
#endif
#if emission
uniform vec3 emission;
#endif
#if reads_uv && !own.pixels
uniform sampler2D base_texture;
#endif
#if reads_checker && !own.pixels
#include "base_checker.glsl"
#endif
#if shown
#include "math_finite.glsl"
#include "display_map.glsl"
#endif

void main()
{
#if fragment.N
#if own
    vec3 N = v_normal; // not unit
#elif normals_unnormalized
    vec3 N = v_normal; // Fault: no stage makes it unit.
#elif renormalize_off
    vec3 N = v_normal; // Fault: interpolation left it shorter than 1.
#elif guard_normal
    vec3 N = v_normal != vec3(0.0) ? normalize(v_normal) : v_normal; // interpolated normals may cancel
#else
    vec3 N = normalize(v_normal);
#endif
#endif
#if wide
    vec3 P = (ray_corner + gl_FragCoord.x * ray_right + gl_FragCoord.y * ray_up) / gl_FragCoord.w; // interpolation over so wide a surface loses digits
#endif
#if fragment.V
#if orthographic
    vec3 V = view_direction;
#elif viewer_infinite
    vec3 V = view_direction; // Fault: the same for every point.
#else
    vec3 V = normalize(${fragment.to_eye});
#endif
#endif
#if fragment.N && fragment.V && two_sided && facing_view
    N = dot(N, V) < 0.0 ? -N : N; // Fault: where an interpolated N leans away, no back is seen.
#elif fragment.N && two_sided
    N = gl_FrontFacing ? N : -N;
#endif
#if both_sides && two_sided && facing_winding
    vec3 vertex_light = gl_FrontFacing ? v_light : v_back_light;
#if vertex.separate_specular
    vec3 vertex_specular = gl_FrontFacing ? v_specular : v_back_specular;
#endif
#elif both_sides
    vec3 vertex_light = v_light;
#if vertex.separate_specular
    vec3 vertex_specular = v_specular;
#endif
#endif
#if textured && !own || textured && own.apart
    vec3 base = texture(base_texture, v_uv).rgb;
#elif chequered && !own || chequered && own.apart
    vec3 base = checker_color(v_object_position);
#elif full
    vec3 base = vec3(1.0);
#elif reads_color && !own || reads_color && own.apart
    vec3 base = v_color;
#endif
#if colored_too && !own || colored_too && own.apart
    base *= v_color;
#endif
#if fragment.separate_specular
    vec3 specular = vec3(0.0);
#endif
#if fragment.lit
    vec3 light = lighting(${fragment.surface_arguments});
#endif
#if shown
    vec3 seen = ${fragment.color};
    color = vec4(finite(seen) ? displayed(seen) : vec3(1.0, 0.0, 1.0), 1.0);
#else
    color = vec4(${fragment.color}, 1.0);
#endif
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
