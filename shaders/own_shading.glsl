#if own.base && !own.pixels
vec3 own_base = vec3(1.0); // texture and chequer are looked up per pixel

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

// The colour of texture or chequer.
vec3 base()
{
#if textured
    return texture(base_texture, v_uv).rgb;
#elif chequered
    return checker_color(v_object_position);
#else
    return vec3(1.0);
#endif
}

#endif
#include "own text"

