#include "vectors_light.glsl" with directional
#include "vectors_light.glsl" with point
#include "vectors_light.glsl" with spot
