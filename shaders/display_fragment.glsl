#version 330 core

layout(location = 0) out vec4 color;

uniform sampler2D linear_picture;
uniform float exposure;

#include "math_finite.glsl"

#if srgb
// IEC 61966-2-1
vec3 srgb_curve(vec3 x)
{
    return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, greaterThan(x, vec3(0.0031308)));
}
#endif

void main()
{
    vec3 light = texelFetch(linear_picture, ivec2(gl_FragCoord.xy), 0).rgb;
    if (!finite(light)) {
        discard; // what it was cleared to stays; the pixels that are drawn are counted
    }
    vec3 shown = clamp(light * exposure, 0.0, 1.0);
#if srgb
    shown = srgb_curve(shown);
#endif
    color = vec4(shown, 1.0);
}
