#include "attenuation_light.glsl" with point
#include "attenuation_light.glsl" with spot
