vec3 point_light(PointLight light${point.parameters})
{
#include "light_position.glsl" with point
#include "light_attenuation.glsl" with point
#include "light_terms.glsl" with point
}

