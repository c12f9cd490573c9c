vec3 directional_light(${light.type} light${light.parameters})
{
#if light.uses_L
    vec3 L = -light.direction;
#endif
#include "light_terms.glsl"
}

