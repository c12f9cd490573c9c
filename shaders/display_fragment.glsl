#version 330 core

layout(location = 0) out vec4 color;

uniform sampler2D linear_picture;

#include "math_finite.glsl"
#include "display_map.glsl"

void main()
{
    vec3 light = texelFetch(linear_picture, ivec2(gl_FragCoord.xy), 0).rgb;
    if (!finite(light)) {
        discard; // what it was cleared to stays; the pixels that are drawn are counted
    }
    color = vec4(displayed(light), 1.0);
}
