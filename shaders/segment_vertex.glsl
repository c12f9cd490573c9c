#version 330 core

layout(location = 0) in vec3 a_from; // an instance's ends; the same: a dot
layout(location = 1) in vec3 a_to;

uniform mat4 model_view_projection;
uniform float width;  // of the picture, pixels
uniform float height;
uniform float radius; // of the line, pixels

flat out vec2 v_from; // pixels from the picture's lower left corner
flat out vec2 v_to;

void main()
{
    vec4 from = model_view_projection * vec4(a_from, 1.0);
    vec4 to = model_view_projection * vec4(a_to, 1.0);
    float from_near = from.z + from.w; // below 0 before the near plane, where the line is cut
    float to_near = to.z + to.w;
    if (from_near < 0.0) {
        from = mix(from, to, clamp(from_near / (from_near - to_near), 0.0, 1.0));
    } else if (to_near < 0.0) {
        to = mix(to, from, to_near / (to_near - from_near));
    }
    vec2 picture = vec2(width, height);
    v_from = (from.xy / from.w * 0.5 + 0.5) * picture;
    v_to = (to.xy / to.w * 0.5 + 0.5) * picture;
    vec2 along = v_to - v_from;
    along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
    vec2 side = vec2(-along.y, along.x) * (gl_VertexID % 2 == 0 ? 1.0 : -1.0);
    vec4 end = gl_VertexID < 2 ? from : to;
    vec2 corner = (radius + 1.0) * (side + (gl_VertexID < 2 ? -along : along)); // a pixel more, for soft edges
    gl_Position = end + vec4(corner / picture * 2.0 * end.w, 0.0, 0.0);
#if deep
    gl_Position.z = 0.0; // the fragment stage writes the depth
#endif
}
