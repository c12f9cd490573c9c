#pragma once

#include "certificate/choice.h"
#include "reference/branches.h"
#include "reference/parallel.h"
#include "reference/raster.h"
#include "reference/surface.h"
#include "scene/resources.h"

#include <span>
#include <vector>

/// The meshes of a scene, with what the technique computes before there are pixels: per vertex or per triangle.
namespace sandbox::reference {

/// What a technique computes before there are pixels. flat: one of each per triangle; per-vertex, hybrid, auto: one
/// per vertex; else empty.
struct Lit {
    std::vector<Reflected> light;
    std::vector<Doubts> doubts;
};

struct MeshObject {
    const Object *object = nullptr;
    const Mesh *mesh = nullptr;
    Setup setup; ///< the scene's, with the origin that OpenGL measures this object's positions from
    WorldTransform to_world;
    BaseColor base;
    std::vector<glm::dvec3> positions; ///< one per vertex, as lit, from the eye
    std::vector<glm::dvec3> normals;   ///< one per vertex, unit, world axes
    Lit front, back;                   ///< as each side is seen; `back` of two-sided objects only
    certificate::ObjectChoice chosen;  ///< of auto

    /// How a triangle is lit: the technique's frequency or what `auto` chose.
    [[nodiscard]] Frequency frequency(std::size_t triangle) const;
};

struct MeshScene {
    Setup setup;
    std::vector<MeshObject> objects;
    std::vector<RasterObject> raster;
};

/// `scene` and `resources` must outlive the result. `high`: as in Setup.
MeshScene prepare_meshes(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                         Size size, const HighValues &high = {});

/// Where flat shading evaluates the equation.
IsolatedPoint centroid(const Setup &setup, const MeshObject &object, const glm::uvec3 &triangle, Side side);

/// A triangle's own normal in object space, turned to the side of its vertices' mean normal; unit.
glm::dvec3 face_normal(const Mesh &mesh, const glm::uvec3 &triangle);

} // namespace sandbox::reference
