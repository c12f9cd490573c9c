#include "capture/sidecar.h"

#include "image/error.h"
#include "scene/scene_file.h"

#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

/// One key of a sidecar, read by `read`; what is wrong with it is said with the file's and the key's name.
template <typename Read> void read_key(const ordered_json &from, const char *key, std::string_view name, Read read) {
    if (!from.contains(key)) {
        return;
    }
    const std::string where = std::string(name) + ": " + key + ": ";
    try {
        read(from.at(key));
    } catch (const InputError &error) {
        throw InputError(where + error.what());
    } catch (const ordered_json::exception &) {
        throw InputError(where + "unexpected value " + from.at(key).dump());
    }
}

double read_share(double value) {
    if (!(value >= 0 && value <= 1)) {
        throw InputError("expected a number from 0 to 1");
    }
    return value;
}

void read_techniques(const ordered_json &value, PictureOptions &options) {
    options.left = parse_technique(value.at(0).get<std::string>());
    options.right = value.size() > 1 ? parse_technique(value.at(1).get<std::string>()) : options.left;
}

} // namespace

std::filesystem::path sidecar_path(const std::filesystem::path &picture) {
    std::filesystem::path path = picture;
    path += ".json";
    return path;
}

std::string sidecar_text(const Scene &scene, const PictureOptions &options, const DrawnBy &by) {
    ordered_json techniques = ordered_json::array({to_string(options.left)});
    if (options.layout != Layout::single) {
        techniques.push_back(to_string(options.right));
    }
    ordered_json out{{"version", SANDBOX_VERSION},
                     {"renderer", by.renderer},
                     {"opengl", by.opengl},
                     {"layout", to_string(options.layout)},
                     {"techniques", techniques},
                     {"size", {options.size.width, options.size.height}},
                     {"display", to_string(options.display)},
                     {"exposure", options.exposure},
                     {"gain", options.gain},
                     {"labels", options.labels}};
    if (options.textbook_left) {
        out["textbook_left"] = true;
    }
    if (options.layout == Layout::wipe) {
        out["divider"] = options.divider;
    }
    if (!options.view.empty()) {
        out["view"] = options.view;
    }
    out["scene"] = ordered_json::parse(scene_text(scene));
    return out.dump(2) + "\n";
}

std::optional<PictureOptions> sidecar_options(std::string_view text, std::string_view name) {
    const ordered_json from = ordered_json::parse(text, nullptr, false);
    if (!from.is_object() || !from.contains("scene") || !from.contains("techniques")) {
        return std::nullopt;
    }
    PictureOptions options;
    read_key(from, "layout", name,
             [&](const auto &v) { options.layout = parse_layout(v.template get<std::string>()); });
    read_key(from, "techniques", name, [&](const auto &v) { read_techniques(v, options); });
    read_key(from, "textbook_left", name, [&](const auto &v) { options.textbook_left = v.template get<bool>(); });
    read_key(from, "size", name, [&](const auto &v) {
        options.size = {v.at(0).template get<int>(), v.at(1).template get<int>()};
    });
    read_key(from, "display", name,
             [&](const auto &v) { options.display = parse_display(v.template get<std::string>()); });
    read_key(from, "exposure", name, [&](const auto &v) { options.exposure = v.template get<double>(); });
    read_key(from, "gain", name, [&](const auto &v) { options.gain = v.template get<double>(); });
    read_key(from, "divider", name, [&](const auto &v) { options.divider = read_share(v.template get<double>()); });
    read_key(from, "labels", name, [&](const auto &v) { options.labels = v.template get<bool>(); });
    read_key(from, "view", name, [&](const auto &v) { options.view = v.template get<std::string>(); });
    return options;
}

} // namespace sandbox
