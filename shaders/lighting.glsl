#include "lights.glsl"
#if stage.constant_ambient
uniform vec3 ambient; // all constant ambient light, times the material
#endif
#if stage.specular && uniform_exponent
uniform float shininess; // the exponent n
#endif
#if stage.uses_view_direction
uniform vec3 view_direction; // towards a viewer at infinity
#endif

#if stage.stable_power
#include "power_stable.glsl"
#endif
#if stage.specular && blinn_phong
#include "reflection_blinn_phong.glsl"
#elif stage.specular && phong
#include "reflection_phong.glsl"
#endif
#if stage.directional
#include "light_directional.glsl"
#endif
#if stage.point
#include "light_point.glsl"
#endif
#if stage.spot
#include "light_spot.glsl"
#endif
#include "all_lights.glsl"
