#include "wireframe_vertex.glsl"
