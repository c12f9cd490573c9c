#include "lights.glsl"
#if stage.constant_ambient
uniform vec3 ambient; // all constant ambient light, times the material
#endif
#if stage.specular && reads_exponent
uniform float shininess; // the exponent n
#endif
#if stage.uses_view_direction
uniform vec3 view_direction; // towards a viewer at infinity
#endif

#if stage.stable_power
#include "power_stable.glsl"
#endif
#each model
#if stage.specular && model.used
#include "reflection_${model.function}.glsl"
#endif
#end
#each light
#if light.used
#include "light_${light.kind}.glsl"
#endif
#end
// All light that leaves the surface${stage.before_base}.
vec3 lighting(${stage.surface_parameters})
{
#if stage.R
    vec3 R = reflect(-V, N); // the mirrored view: R.L is the mirrored light's R.V
#endif
    vec3 sum = ${stage.first_sum};
#each light
#if light.used && light.loops
    for (int i = ${light.first}; i < ${light.end}; ++i) {
        sum += ${light.calls};
    }
#elif light.used
    sum += ${light.calls};
#endif
#end
    return sum;
}
