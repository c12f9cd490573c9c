vec3 spot_light(${light.type} light${light.parameters})
{
#include "light_position.glsl"
#include "light_attenuation.glsl"
#if light.uses_cone
#include "light_cone.glsl"
#endif
#include "light_terms.glsl"
}

