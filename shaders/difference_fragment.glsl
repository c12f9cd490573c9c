#version 330 core

layout(location = 0) out vec4 color;

uniform sampler2D left_picture;
uniform sampler2D right_picture;
uniform float gain;

#include "math_finite.glsl"

// About as bright as eyes see it; 0 where it is not finite.
float lightness(ivec2 pixel)
{
    ivec2 last = textureSize(left_picture, 0) - 1;
    vec3 p = texelFetch(left_picture, clamp(pixel, ivec2(0), last), 0).rgb;
    return finite(p) ? sqrt(clamp(dot(p, vec3(0.2126, 0.7152, 0.0722)), 0.0, 1.0)) : 0.0;
}

// How dark the outline is: larger where the left picture's lightness changes within two pixels.
float outline(ivec2 pixel)
{
    float change = abs(lightness(pixel + ivec2(1, 0)) - lightness(pixel - ivec2(1, 0))) +
                   abs(lightness(pixel + ivec2(0, 1)) - lightness(pixel - ivec2(0, 1)));
    return 0.25 * min(1.0, 3.0 * change);
}

// Signed difference in a palette that is safe for colour-blind eyes: orange where the left picture is brighter,
// blue where the right one is, white where they agree, over a faint outline of the left picture. Its twin is image/difference.cpp.
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
    color = vec4(finite(left) && finite(right) ? mix(vec3(1.0), end, abs(t)) * (1.0 - outline(pixel))
                                                : vec3(1.0, 0.0, 1.0),
                 1.0);
}
