vec3 directional_light(DirectionalLight light${directional.parameters})
{
#if directional.uses_L
    vec3 L = -light.direction;
#endif
#include "light_terms.glsl" with directional
}

