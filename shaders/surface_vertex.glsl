#if reads_model && own
uniform mat4 model; // world space
#elif reads_model && position_absolute && !full
uniform mat4 model; // Fault: world space, far from whose origin float32 is coarse
#elif reads_model && off_eye && !full
uniform mat4 model; // world space, moved so that the object's middle is the origin: the eye is too far away
#elif reads_model
uniform mat4 model; // world space, moved so that the eye is the origin
#endif
#if reads_normal_matrix && normals_unnormalized && !full
uniform mat3 normal_matrix; // of model, as it is
#elif reads_normal_matrix && normals_cofactor && !full
uniform mat3 normal_matrix; // cofactors of model
#elif reads_normal_matrix && normals_view_space && !full
uniform mat3 normal_matrix; // inverse transpose of model, then view space
#elif reads_normal_matrix
uniform mat3 normal_matrix; // inverse transpose of model
#endif
#if reads_eye
uniform vec3 eye;
#endif
#if own.moved
uniform vec3 mesh_origin; // the middle of a mesh far from its own origin, which its vertices are measured from
#endif

#if vertex.P
vec3 surface_position()
{
#if own.position && own.moved
    return position(${vertex.point} + mesh_origin);
#elif own.position
    return position(${vertex.point});
#elif position_w0
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
#if own.normal
    return normal(a_normal);
#elif normals_untransformed
    return a_normal; // Fault: still in object space.
#elif normals_model_matrix && guard_vertex_normal
    return guarded_unit(mat3(model) * a_normal, a_normal); // Fault: wrong under non-uniform scale.
#elif normals_model_matrix
    return normalize(mat3(model) * a_normal); // Fault: wrong under non-uniform scale.
#elif normals_unnormalized
    return normal_matrix * a_normal; // Fault: the scale of model stays in N.
#elif normals_cofactor && guard_vertex_normal
    return guarded_unit(normal_matrix * a_normal, a_normal); // Fault: lacks the sign of the determinant.
#elif normals_cofactor
    return normalize(normal_matrix * a_normal); // Fault: lacks the sign of the determinant.
#elif normals_view_space && guard_vertex_normal
    return guarded_unit(normal_matrix * a_normal, a_normal); // Fault: all else is in world space.
#elif normals_view_space
    return normalize(normal_matrix * a_normal); // Fault: all else is in world space.
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
