#include "reference/mesh_scene.h"

#include "certificate/choice.h"
#include "scene/space.h"
#include "shading/eye_space.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace sandbox::reference {

namespace {

/// Vertices or triangles that one thread takes at a time.
constexpr std::size_t piece = 1024;

void for_pieces(std::size_t count, const std::function<void(std::size_t)> &work) {
    parallel_for((count + piece - 1) / piece, [&](std::size_t p) {
        for (std::size_t i = p * piece; i < std::min(count, (p + 1) * piece); ++i) {
            work(i);
        }
    });
}

RasterObject to_pixels(const MeshObject &object, int window_grid, const Camera &camera, Size size) {
    const double aspect = aspect_of(size);
    const glm::dmat4 projection = view_projection(camera, aspect);
    const Transform &transform = object.object->transform;
    RasterObject raster;
    raster.triangles = &object.mesh->triangles;
    raster.window_grid = window_grid;
    raster.near = camera.near_plane;
    raster.far = camera.far_plane;
    if (back_faces_hidden(camera, aspect, transform, *object.mesh)) {
        raster.hidden = is_mirrored(transform) ? -1 : 1;
    }
    raster.corners.resize(object.mesh->positions.size());
    raster.nearness.resize(is_orthographic(camera) ? raster.corners.size() : 0);
    for_pieces(raster.corners.size(), [&](std::size_t i) {
        const glm::dvec4 clip = projection * glm::dvec4(object.to_world.seen(object.mesh->positions[i]), 1);
        raster.corners[i] = {(clip.w + clip.x) * 0.5 * size.width, (clip.w - clip.y) * 0.5 * size.height, clip.w};
        if (!raster.nearness.empty()) {
            raster.nearness[i] = 0.5 - 0.5 * clip.z;
        }
    });
    return raster;
}

/// Lights `count` points, the i-th of which is point_at(i, side), as their front is seen and, if need be, their back.
template <class PointAt> void light(MeshObject &object, Terms terms, std::size_t count, const PointAt &point_at) {
    const auto light_side = [&](Lit &lit, Side side) {
        lit.light.resize(count);
        lit.doubts.resize(count);
        for_pieces(count, [&](std::size_t i) {
            const IsolatedPoint at = point_at(i, side);
            const SurfacePoint point = at.point_at(0, 0);
            lit.light[i] = at.reflect(terms, point);
            lit.doubts[i] = at.doubts(terms, point);
        });
    };
    light_side(object.front, Side::front);
    if (object.object->two_sided) {
        light_side(object.back, Side::back);
    }
}

void light_faces(const Setup &setup, MeshObject &object) {
    const std::vector<glm::uvec3> &triangles = object.mesh->triangles;
    light(object, Terms::all, triangles.size(),
          [&](std::size_t i, Side side) { return centroid(setup, object, triangles[i], side); });
}

void light_vertices(const Setup &setup, MeshObject &object, Terms terms) {
    light(object, terms, object.positions.size(), [&](std::size_t i, Side side) {
        return IsolatedPoint(setup, *object.object, object.positions[i], object.normals[i], side);
    });
}

MeshObject prepare_object(const Setup &shared, const Scene &scene, const Object &object,
                          const ObjectResources &resources) {
    MeshObject prepared;
    prepared.object = &object;
    prepared.mesh = resources.mesh.get();
    prepared.setup = shared;
    prepared.setup.origin = eye_space(scene, object, *resources.mesh, shared.technique).lit_origin - shared.eye;
    const Setup &setup = prepared.setup;
    prepared.to_world = world_transform(object.transform, setup);
    prepared.base = base_color(object, resources);
    const std::size_t count = prepared.mesh->positions.size();
    prepared.positions.resize(count);
    prepared.normals.resize(count);
    for_pieces(count, [&](std::size_t i) {
        prepared.positions[i] = prepared.to_world.lit(prepared.mesh->positions[i]);
        prepared.normals[i] = prepared.to_world.normal(prepared.mesh->normals[i]);
    });
    switch (setup.technique.frequency) {
    case Frequency::flat:
        light_faces(setup, prepared);
        break;
    case Frequency::per_vertex:
    case Frequency::automatic:
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

IsolatedPoint centroid(const Setup &setup, const MeshObject &object, const glm::uvec3 &triangle, Side side) {
    const std::vector<glm::dvec3> &p = object.positions;
    return {setup, *object.object, (p[triangle.x] + p[triangle.y] + p[triangle.z]) / 3.0,
            object.to_world.normal(face_normal(*object.mesh, triangle)), side};
}

Frequency MeshObject::frequency(std::size_t triangle) const {
    const Frequency asked = setup.technique.frequency;
    if (asked != Frequency::automatic) {
        return asked;
    }
    return chosen.shows(triangle) ? chosen.part(triangle).frequency : Frequency::per_pixel;
}

MeshScene prepare_meshes(const Scene &scene, const std::vector<ObjectResources> &resources, const Technique &technique,
                         Size size, const HighValues &high) {
    MeshScene meshes;
    meshes.setup = prepare(scene, technique);
    meshes.setup.high = high;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        meshes.objects.push_back(prepare_object(meshes.setup, scene, scene.objects[i], resources[i]));
        meshes.raster.push_back(to_pixels(meshes.objects.back(), resources[i].window_grid, scene.camera, size));
    }
    if (technique.frequency == Frequency::automatic) {
        certificate::Choice choice = certificate::choose(scene, resources, technique, aspect_of(size));
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            meshes.objects[i].chosen = std::move(choice.objects[i]);
        }
    }
    return meshes;
}

} // namespace sandbox::reference
