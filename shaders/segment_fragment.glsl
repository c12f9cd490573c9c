#version 330 core

layout(location = 0) out vec4 color;

uniform vec3 line_color;
uniform float radius; // pixels
#if deep
uniform float depth_per_octave;
uniform float depth_at_1;
#endif

flat in vec2 v_from;
flat in vec2 v_to;

void main()
{
    vec2 along = v_to - v_from;
    vec2 here = gl_FragCoord.xy - v_from;
    float squared = dot(along, along);
    float share = squared > 0.0 ? clamp(dot(here, along) / squared, 0.0, 1.0) : 0.0;
    color = vec4(line_color, clamp(radius + 0.5 - length(here - share * along), 0.0, 1.0));
#if deep
    gl_FragDepth = depth_at_1 - depth_per_octave * log2(gl_FragCoord.w); // as the surfaces have it
#endif
}
