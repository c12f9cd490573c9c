#include "scene/scene_file.h"

#include "image/error.h"
#include "image/file_io.h"
#include "scene/model_scene.h"
#include "scene/read_json.h"
#include "scene/scene_read.h"
#include "scene/scene_write.h"
#include "scene/suggest.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
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

Scene open_scene_file(const fs::path &path) {
    if (is_model(path)) {
        return scene_of_model(path, unknown_aspect);
    }
    std::error_code failed;
    if (fs::status(path, failed).type() == fs::file_type::not_found) { // one that may not be looked at is not missing
        throw InputError("{}: no such file", path.string());
    }
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return static_cast<char>(tolower(c)); });
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

std::string scene_text(const Scene &scene, const fs::path &folder) {
    Scene written = scene;
    for (Object &object : written.objects) {
        object.material.texture = path_from(object.material.texture, folder);
        if (auto *obj = std::get_if<ObjShape>(&object.mesh)) {
            obj->path = path_from(obj->path, folder);
        }
    }
    return print_json(write_scene(written, Keys::needed));
}

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
