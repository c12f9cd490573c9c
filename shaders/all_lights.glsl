// All light that leaves the surface${stage.before_base}.
vec3 lighting(${stage.surface_parameters})
{
#if stage.R
    vec3 R = reflect(-V, N); // the mirrored view: R.L is the mirrored light's R.V
#endif
    vec3 sum = ${stage.first_sum};
#if stage.directional
#include "each_light.glsl" with directional
#endif
#if stage.point
#include "each_light.glsl" with point
#endif
#if stage.spot
#include "each_light.glsl" with spot
#endif
    return sum;
}
