#include "reference/mesh_scene.h"

#include "reference/branches.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

namespace sandbox::reference {

namespace {

/// Work is handed out in pieces of this many vertices or triangles.
constexpr std::size_t piece = 1024;

void for_pieces(std::size_t count, const std::function<void(std::size_t)> &work) {
    parallel_for((count + piece - 1) / piece, [&](std::size_t p) {
        for (std::size_t i = p * piece; i < std::min(count, (p + 1) * piece); ++i) {
            work(i);
        }
    });
}

/// RasterObject::hidden. The inside of a closed mesh is seen where it is flattened, and from within the box around it,
/// which the near plane's corners must not reach into.
int hidden_side(const Camera &camera, const Transform &transform, const Mesh &mesh, Size size) {
    const glm::dvec3 &scale = transform.scale;
    const bool mirrored = ((scale.x < 0) != (scale.y < 0)) != (scale.z < 0);
    const double tangent = std::tan(glm::radians(camera.fov_y_degrees / 2));
    const double corner = std::hypot(1, tangent, tangent * size.width / size.height) * camera.near_plane;
    if (!mesh.closed || scale.x == 0 || scale.y == 0 || scale.z == 0 ||
        distance_to_bounds(transform, mesh.bounds, camera.position) <= corner) {
        return 0;
    }
    return mirrored ? -1 : 1;
}

RasterObject corners_of(const MeshObject &object, const glm::dmat4 &projection, Size size, int hidden) {
    RasterObject raster;
    raster.triangles = &object.mesh->triangles;
    raster.hidden = hidden;
    raster.corners.resize(object.mesh->positions.size());
    for_pieces(raster.corners.size(), [&](std::size_t i) {
        const glm::dvec4 clip = projection * glm::dvec4(object.placement.seen(object.mesh->positions[i]), 1);
        raster.corners[i] = {(clip.w + clip.x) * 0.5 * size.width, (clip.w - clip.y) * 0.5 * size.height, clip.w};
    });
    return raster;
}

void light_point(const Setup &setup, MeshObject &object, Terms terms, std::size_t i, const glm::dvec3 &position,
                 const glm::dvec3 &normal) {
    const Material &material = object.object->material;
    const Point point(setup, object.object->two_sided, position, normal);
    const Place place = point.at(0, 0);
    object.lit[i] = reflect(setup, material, terms, place, point);
    object.unstable[i] = may_jump(setup, material, object.object->two_sided, terms, place, point) ? 1 : 0;
}

void light_faces(const Setup &setup, MeshObject &object) {
    const Mesh &mesh = *object.mesh;
    object.lit.resize(mesh.triangles.size());
    object.unstable.resize(mesh.triangles.size());
    for_pieces(mesh.triangles.size(), [&](std::size_t i) {
        const glm::uvec3 &t = mesh.triangles[i];
        const glm::dvec3 centroid = (object.positions[t.x] + object.positions[t.y] + object.positions[t.z]) / 3.0;
        const glm::dvec3 normal = transform_normal(object.placement.normals, face_normal(mesh, t));
        light_point(setup, object, Terms::all, i, centroid, normal);
    });
}

void light_vertices(const Setup &setup, MeshObject &object, Terms terms) {
    object.lit.resize(object.positions.size());
    object.unstable.resize(object.positions.size());
    for_pieces(object.positions.size(),
               [&](std::size_t i) { light_point(setup, object, terms, i, object.positions[i], object.normals[i]); });
}

MeshObject prepare_object(const Setup &setup, const Object &object, const ObjectResources &resources) {
    MeshObject prepared;
    prepared.object = &object;
    prepared.mesh = resources.mesh.get();
    prepared.placement = place(object.transform, setup);
    prepared.base = base_color(object, resources);
    const std::size_t count = prepared.mesh->positions.size();
    prepared.positions.resize(count);
    prepared.normals.resize(count);
    for_pieces(count, [&](std::size_t i) {
        prepared.positions[i] = prepared.placement.lit(prepared.mesh->positions[i]);
        prepared.normals[i] = transform_normal(prepared.placement.normals, prepared.mesh->normals[i]);
    });
    switch (setup.technique.frequency) {
    case Frequency::flat:
        light_faces(setup, prepared);
        break;
    case Frequency::per_vertex:
        light_vertices(setup, prepared, Terms::all);
        break;
    case Frequency::hybrid:
        light_vertices(setup, prepared, Terms::body);
        break;
    case Frequency::per_pixel:
    case Frequency::interpolated_vectors:
        break;
    }
    return prepared;
}

} // namespace

glm::dvec3 face_normal(const Mesh &mesh, const glm::uvec3 &triangle) {
    const glm::dvec3 &a = mesh.positions[triangle.x];
    const glm::dvec3 normal = unit(glm::cross(mesh.positions[triangle.y] - a, mesh.positions[triangle.z] - a));
    const glm::dvec3 mean = mesh.normals[triangle.x] + mesh.normals[triangle.y] + mesh.normals[triangle.z];
    return glm::dot(normal, mean) < 0 ? -normal : normal;
}

MeshScene prepare_meshes(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                         Size size) {
    MeshScene meshes;
    meshes.setup = prepare(scene, technique);
    const glm::dmat4 projection = view_projection(scene.camera, size.width / static_cast<double>(size.height));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        meshes.objects.push_back(prepare_object(meshes.setup, scene.objects[i], resources[i]));
        const int hidden = hidden_side(scene.camera, scene.objects[i].transform, *resources[i].mesh, size);
        meshes.raster.push_back(corners_of(meshes.objects.back(), projection, size, hidden));
    }
    return meshes;
}

} // namespace sandbox::reference
