vec3 spot_light(SpotLight light${spot.parameters})
{
#include "light_position.glsl" with spot
#include "light_attenuation.glsl" with spot
#if spot.uses_cone
#include "light_cone.glsl"
#endif
#include "light_terms.glsl" with spot
}

