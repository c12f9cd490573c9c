vec3 point_light(${light.type} light${light.parameters})
{
#include "light_position.glsl"
#include "light_attenuation.glsl"
#include "light_terms.glsl"
}

