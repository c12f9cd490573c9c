#include "shading/vertex_marks.h"

#include "scene/space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace sandbox {
namespace {

/// The cube, `apart` wide, that holds a point, moved by some cubes; different cubes may have the same number.
std::uint64_t cube_number(const glm::dvec3 &point, double apart, const glm::dvec3 &moved) {
    const glm::dvec3 cube = glm::floor(point / apart) + moved;
    std::uint64_t number = 0;
    for (int axis = 0; axis < 3; ++axis) {
        number = number * 0x9E3779B97F4A7C15U +
                 static_cast<std::uint64_t>(static_cast<std::int64_t>(std::clamp(cube[axis], -1e15, 1e15)));
    }
    return number;
}

} // namespace

double rounded_length(const Camera &camera, double share) {
    return std::exp2(std::round(std::log2(share * height_at_target(camera))));
}

std::vector<MarkedVertex> marked_vertices(const Mesh &mesh, bool flat) {
    std::vector<MarkedVertex> marked;
    if (!flat) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            marked.push_back({mesh.positions[i], mesh.normals[i]});
        }
        return marked;
    }
    for (const glm::uvec3 &t : mesh.triangles) {
        const glm::dvec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0;
        marked.push_back({middle, facet_normal(mesh, t)});
    }
    return marked;
}

std::vector<MarkedVertex> thinned_out(const std::vector<MarkedVertex> &vertices, const glm::dvec3 &scale,
                                      double apart) {
    std::vector<MarkedVertex> kept;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> in_cube; // of `kept`
    std::vector<glm::dvec3> around{glm::dvec3(0)};                       // the vertex's own cube is likely to tell
    for (int i = 0; i < 27; ++i) {
        around.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    }
    for (const MarkedVertex &vertex : vertices) {
        const glm::dvec3 place = scale * vertex.position;
        const bool crowded = std::ranges::any_of(around, [&](const glm::dvec3 &moved) {
            const auto cube = in_cube.find(cube_number(place, apart, moved));
            return cube != in_cube.end() && std::ranges::any_of(cube->second, [&](std::size_t i) {
                       return glm::distance(scale * kept[i].position, place) < apart &&
                              glm::dot(kept[i].normal, vertex.normal) > 0.5;
                   });
        });
        if (!crowded) {
            in_cube[cube_number(place, apart, glm::dvec3(0))].push_back(kept.size());
            kept.push_back(vertex);
        }
    }
    return kept;
}

std::vector<MarkLine> vertex_dots(const std::vector<MarkedVertex> &vertices, const Scene &scene, const Object &object) {
    const glm::dmat3 linear = linear_part(object.transform);
    std::vector<MarkLine> dots;
    for (const MarkedVertex &vertex : vertices) {
        const glm::dvec3 at = linear * vertex.position + (object.transform.translate - scene.camera.position);
        dots.push_back({at, at});
    }
    return dots;
}

std::vector<MarkLine> normal_lines(const std::vector<MarkedVertex> &vertices, const Scene &scene,
                                   const Technique &technique, const Object &object, const EyeSpace &space) {
    const glm::dmat3 matrix = normal_matrix(technique.normals, scene.camera, object, space);
    const double length = normal_length * height_at_target(scene.camera);
    std::vector<MarkLine> lines = vertex_dots(vertices, scene, object);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const glm::dvec3 sum = matrix * vertices[i].normal;
        const bool unit = technique.normals == Normals::unnormalized;
        const glm::dvec3 normal = unit ? sum : glm::dot(sum, sum) > 0 ? glm::normalize(sum) : vertices[i].normal;
        lines[i].to += length * normal;
    }
    return lines;
}

MarkLine lifted(const MarkLine &line, const Camera &camera, double width, int height) {
    constexpr double steepest = 3.7; // tan(75 degrees)
    const double lift = steepest * width / 2 * view_height(camera, 1) / height;
    const glm::dvec3 back = camera_axes(camera).forward * lift;
    const auto nearer = [&](const glm::dvec3 &p) { return is_orthographic(camera) ? p - back : p * (1 - lift); };
    return {nearer(line.from), nearer(line.to)};
}

} // namespace sandbox
