#version 330 core

layout(location = 0) out vec4 color;

uniform sampler2D left_picture;
uniform sampler2D right_picture;
uniform float gain;

#include "math_finite.glsl"

// Signed difference in a palette that is safe for colour-blind eyes: orange where the left picture is brighter,
// blue where the right one is, white where they agree.
void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 left = texelFetch(left_picture, pixel, 0).rgb;
    vec3 right = texelFetch(right_picture, pixel, 0).rgb;
    vec3 difference = left - right;
    vec3 size = abs(difference);
    float largest = size.r >= size.g && size.r >= size.b ? difference.r
                                                         : (size.g >= size.b ? difference.g : difference.b);
    float t = clamp(gain * largest, -1.0, 1.0);
    vec3 end = t > 0.0 ? vec3(0.85, 0.37, 0.01) : vec3(0.13, 0.35, 0.75);
    color = vec4(finite(left) && finite(right) ? mix(vec3(1.0), end, abs(t)) : vec3(1.0, 0.0, 1.0), 1.0);
}
