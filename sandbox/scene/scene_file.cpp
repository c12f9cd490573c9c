#include "scene/scene_file.h"

#include "image/error.h"
#include "image/file_io.h"
#include "scene/obj_reader.h"
#include "scene/read_json.h"
#include "scene/scene_read.h"
#include "scene/scene_write.h"
#include "scene/suggest.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 14> teaching_order{"studio",
                                                          "three-point-lights",
                                                          "three-point-lights-original",
                                                          "three-directional-lights",
                                                          "box-1-colour",
                                                          "box-2-ambient",
                                                          "box-3-diffuse",
                                                          "box-4-normal-matrix",
                                                          "box-5-specular",
                                                          "chequered-sphere",
                                                          "directional-light",
                                                          "point-light",
                                                          "spot-light",
                                                          "vase"};

std::string scene_path(std::string_view name) { return fmt::format("scenes/{}.json", name); }

/// An OBJ file under two lights from the viewer's side, framed by the camera.
Scene scene_of_model(const fs::path &path) {
    const Mesh mesh = read_obj(read_file(path), path.string());
    const glm::dvec3 centre = (mesh.bounds.low + mesh.bounds.high) / 2.0;
    const double radius = glm::length(mesh.bounds.high - mesh.bounds.low) / 2;
    Scene scene;
    scene.name = path.stem().string();
    scene.camera.target = centre;
    scene.camera.position = centre + radius * glm::dvec3(0.9, 0.8, 2.6);
    scene.camera.near_plane = radius * 0.05;
    scene.camera.far_plane = radius * 50;
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
    scene.objects = {object};
    return scene;
}

Scene open_scene_file(const fs::path &path) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        throw InputError("{}: no such file", path.string());
    }
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(tolower(c)); });
    if (extension == ".obj") {
        return scene_of_model(path);
    }
    if (extension != ".json") {
        throw InputError("{}: expected a .json or .obj file", path.string());
    }
    return parse_scene(read_file(path, largest_json), path.string(), fs::absolute(path).parent_path());
}

} // namespace

Scene parse_scene(std::string_view text, std::string_view name, const fs::path &folder) {
    const Json json = read_json<Json>(text, name);
    const bool sidecar = json.is_object() && json.contains("scene") && json["scene"].is_object();
    return read_scene(sidecar ? json["scene"] : json, name, folder);
}

std::string scene_text(const Scene &scene) { return print_json(write_scene(scene, Keys::needed)); }

Scene open_scene(std::string_view name_or_path, const Assets &assets) {
    if (const auto text = assets.read(scene_path(name_or_path))) {
        return parse_scene(*text, scene_path(name_or_path), assets.folder().empty() ? "" : assets.folder() / "scenes");
    }
    const fs::path path(name_or_path);
    if (path.has_parent_path() || path.has_extension()) {
        return open_scene_file(path);
    }
    const std::vector<std::string> scenes = builtin_scenes(assets);
    const std::vector<std::string_view> known(scenes.begin(), scenes.end());
    throw InputError("{}: no built-in scene of that name{}", name_or_path, suggestion(name_or_path, known));
}

std::vector<std::string> builtin_scenes(const Assets &assets) {
    std::vector<std::string> names;
    for (const std::string &path : assets.list("scenes/")) {
        if (path.ends_with(".json")) {
            names.push_back(path.substr(7, path.size() - 12));
        }
    }
    std::ranges::stable_sort(names, {}, [](const std::string &name) {
        return std::ranges::find(teaching_order, name) - teaching_order.begin();
    });
    return names;
}

Scene with_view(Scene scene, std::string_view view) {
    std::vector<std::string_view> known;
    for (const View &candidate : scene.views) {
        if (candidate.name == view) {
            scene.camera = candidate.camera;
            return scene;
        }
        known.push_back(candidate.name);
    }
    throw InputError("--view {}: no such view of this scene{}", view,
                     known.empty() ? "; it has none" : suggestion(view, known));
}

} // namespace sandbox
