#include "scene/model_scene.h"

#include "image/error.h"
#include "image/file_io.h"
#include "image/plain_text.h"
#include "scene/mesh_backs.h"
#include "scene/obj_reader.h"
#include "scene/scene_format.h"
#include "scene/scene_read.h"
#include "scene/space.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <system_error>

namespace sandbox {
namespace fs = std::filesystem;
namespace {

/// Of half the width of a view: what lies farther out from its middle counts as cut off.
constexpr double used_width = 0.95;

/// How far from its target a camera must be to show all corners of `bounds` between the sides of the view.
double distance_for_width(const Camera &camera, const Bounds &bounds, double aspect) {
    const CameraAxes axes = camera_axes(camera);
    const double slope = used_width * aspect * std::tan(glm::radians(camera.fov_y_degrees) / 2);
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                            (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                            (corner & 4) != 0 ? bounds.high.z : bounds.low.z);
        const glm::dvec3 from_target = at - camera.target;
        const double nearer = -glm::dot(from_target, axes.forward);
        distance = std::max(distance, nearer + std::abs(glm::dot(from_target, axes.right)) / slope);
    }
    return distance;
}

Camera camera_around(const Bounds &bounds, double aspect) {
    Camera camera;
    camera.target = (bounds.low + bounds.high) / 2.0;
    const double radius = glm::length(bounds.high - bounds.low) / 2;
    const glm::dvec3 offset = radius * glm::dvec3(0.9, 0.8, 2.6); // all of the ball around it is within the height
    camera.position = camera.target + offset;
    const double room = camera_coordinate.high - std::max({std::abs(camera.target.x), std::abs(camera.target.y),
                                                           std::abs(camera.target.z)}); // a scene file's
    const double back = std::clamp(distance_for_width(camera, bounds, aspect) / glm::length(offset), 1.0,
                                   std::max(1.0, room / offset.z));
    camera.position = camera.target + back * offset;
    camera.near_plane = radius * 0.05;
    camera.far_plane = radius * 50 * back;
    return camera;
}

/// Whether both sides of the triangles are to be lit, and why; empty: the fronts alone are seen. A mesh most of whose
/// normals stand on the backs of its triangles is lit by those normals.
std::string why_two_sided(const Mesh &mesh) {
    const BacksSeen seen = backs_seen(mesh);
    if (seen == BacksSeen::none || mesh.against_normals > mesh.triangles.size() / 2) {
        return "";
    }
    return seen == BacksSeen::open ? "it does not enclose a volume" : "it is wound inside out";
}

} // namespace

bool is_model(const fs::path &path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".obj";
}

Scene scene_of_model(const fs::path &path, double aspect) {
    std::error_code failed;
    if (fs::status(path, failed).type() == fs::file_type::not_found) {
        throw InputError("{}: no such file", path.string());
    }
    const Mesh mesh = read_obj(read_file(path), path.string()); // its notes are said where it is drawn
    Scene scene;
    scene.name = path.stem().string();
    scene.camera = camera_around(mesh.bounds, aspect);
    scene.background = glm::dvec3(0.02, 0.02, 0.03);
    Light key;
    key.type = LightType::directional;
    key.direction = {-1, -1.5, -1};
    key.ambient = 0.1;
    key.diffuse = 0.7;
    key.specular = 0.4;
    Light fill = key;
    fill.direction = {1, -0.2, -0.6};
    fill.ambient = 0;
    fill.diffuse = 0.25;
    fill.specular = 0;
    scene.lights = {key, fill};
    Object object;
    object.name = scene.name;
    object.mesh = ObjShape{checked_path(fs::absolute(path).lexically_normal())};
    if (const std::string why = why_two_sided(mesh); !why.empty()) {
        object.two_sided = true;
        fmt::print(stderr, "note: {}: {}: both sides of its triangles are lit (two_sided)\n", plain_text(path.string()),
                   why);
    }
    scene.objects = {object};
    return scene;
}

} // namespace sandbox
