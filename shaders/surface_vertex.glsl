#if reads_model
uniform mat4 model; // world space, moved so that the eye is the origin
#endif
#if reads_normal_matrix
uniform mat3 normal_matrix; // inverse transpose of model
#endif
#if reads_eye
uniform vec3 eye;
#endif

#if vertex.P
vec3 surface_position()
{
#if position_w0
    // Fault: w = 0 drops the translation.
    return (model * vec4(${vertex.point}, 0.0)).xyz - eye;
#else
    return (model * vec4(${vertex.point}, 1.0)).xyz;
#endif
}

#endif
#if vertex.N
#if guard_vertex_normal
#include "math_unit.glsl"

#endif
vec3 surface_normal()
{
#if normals_untransformed
    return a_normal; // Fault: still in object space.
#elif normals_model_matrix && guard_vertex_normal
    return guarded_unit(mat3(model) * a_normal, a_normal); // Fault: wrong under non-uniform scale.
#elif normals_model_matrix
    return normalize(mat3(model) * a_normal); // Fault: wrong under non-uniform scale.
#elif normals_general && guard_vertex_normal
    return guarded_unit(normal_matrix * a_normal, a_normal); // a flattened object may leave nothing
#elif normals_general
    return normalize(normal_matrix * a_normal);
#elif normals_rigid
    return mat3(model) * a_normal;
#else
    return a_normal;
#endif
}
#endif
