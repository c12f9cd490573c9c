#if directional.declared
#include "light_struct.glsl" with directional
#endif
#if point.declared
#include "light_struct.glsl" with point
#endif
#if spot.declared
#include "light_struct.glsl" with spot
#endif
