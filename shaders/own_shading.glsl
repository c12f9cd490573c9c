#if own.base && !own.pixels
vec3 own_base = vec3(1.0); // the base colour is looked up per pixel

vec3 base()
{
    return own_base;
}

#elif own.base
#if textured
uniform sampler2D base_texture;
#elif chequered
#include "base_checker.glsl"
#endif

// The colour of texture or chequer, times that of the vertices.
vec3 base()
{
#if textured && reads_color
    return texture(base_texture, v_uv).rgb * v_color;
#elif textured
    return texture(base_texture, v_uv).rgb;
#elif chequered && reads_color
    return checker_color(v_object_position) * v_color;
#elif chequered
    return checker_color(v_object_position);
#elif reads_color
    return v_color;
#else
    return vec3(1.0);
#endif
}

#endif
#include "own text"

