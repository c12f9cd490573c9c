#if directional.any
#include "vectors_light.glsl" with directional
#endif
#if point.any
#include "vectors_light.glsl" with point
#endif
#if spot.any
#include "vectors_light.glsl" with spot
#endif
