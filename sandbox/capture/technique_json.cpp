#include "capture/technique_json.h"

#include "scene/scene_read.h"
#include "shading/own_text.h"

#include <nlohmann/json.hpp>
#include <system_error>

namespace sandbox {

using nlohmann::ordered_json;

namespace {

namespace fs = std::filesystem;

/// A file that is there; else the name may be anything, and stays.
bool is_file(const fs::path &path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

} // namespace

ordered_json technique_json(const Technique &technique, const fs::path &folder) {
    if (!technique.own) {
        return to_string(technique);
    }
    const std::string &name = technique.own->file;
    const bool relative = !folder.empty() && is_file(name); // to the current folder
    const std::string file = path_from(relative ? fs::absolute(name).string() : name, folder);
    return {{"technique", to_string(technique)}, {"file", file}, {"own", technique.own->text}};
}

Technique technique_of(const ordered_json &json, const fs::path &folder) {
    if (!json.is_object()) {
        return parse_technique(json.get<std::string>());
    }
    const auto name = json.at("file").get<std::string>();
    const bool beside = !folder.empty() && fs::path(name).is_relative() && is_file(folder / name);
    const OwnShader own(beside ? (folder / name).lexically_normal().string() : name, json.at("own").get<std::string>());
    return parse_technique_with(own, json.at("technique").get<std::string>());
}

} // namespace sandbox
