#version 330 core

layout(location = 0) out vec4 color;

uniform vec3 line_color;
uniform float stripe; // pixels from one stripe to the next, along a row
#if deep
uniform float depth_per_octave;
uniform float depth_at_1;
#endif

void main()
{
    if (mod(gl_FragCoord.x + gl_FragCoord.y, stripe) > 0.25 * stripe) {
        discard;
    }
    color = vec4(line_color, 1.0);
#if deep
    gl_FragDepth = depth_at_1 - depth_per_octave * log2(gl_FragCoord.w); // as the surfaces have it
#endif
}
