#include "teach/files/scene_source.h"

#include "scene/scene_file.h"
#include "teach/files/text_read.h"

#include <nlohmann/json.hpp>

namespace sandbox {

Scene scene_from(const JsonText &source, const std::string &place, const std::filesystem::path &folder,
                 const Assets &assets) {
    const nlohmann::json value = nlohmann::json::parse(source.json);
    if (value.is_object()) {
        return parse_scene(source.json, place, folder);
    }
    const auto name = value.get<std::string>();
    return at(place, [&] {
        return open_scene(std::filesystem::path(name).has_extension() ? (folder / name).string() : name, assets);
    });
}

} // namespace sandbox
