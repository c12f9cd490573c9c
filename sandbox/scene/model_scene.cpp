#include "scene/model_scene.h"

#include "image/error.h"
#include "scene/mesh.h"
#include "scene/model_objects.h"
#include "scene/obj_reader.h"
#include "scene/scene_format.h"
#include "scene/space.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <system_error>
#include <utility>

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
    Object like;
    like.name = path.stem().string();
    ModelObjects model = objects_of_model(path, like);
    Scene scene;
    scene.name = like.name;
    scene.camera = camera_around({model.low, model.high}, aspect);
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
    scene.objects = std::move(model.objects);
    if (!model.why_two_sided.empty()) {
        std::ranges::for_each(scene.objects, [](Object &object) { object.two_sided = true; });
        model.notes.push_back(model.why_two_sided + ": both sides of its triangles are lit (two_sided)");
    }
    say_notes(path.string(), model.notes);
    return scene;
}

} // namespace sandbox
