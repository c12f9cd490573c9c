#include "capture/sidecar.h"

#include "capture/picture_ranges.h"
#include "capture/samples.h"
#include "capture/sidecar_json.h"
#include "capture/technique_json.h"
#include "image/error.h"
#include "image/picture_size.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

/// Hands the value of `key`, if there is one, to `read`. An error names the file and the key.
template <typename Read> void read_key(const ordered_json &from, const char *key, std::string_view name, Read read) {
    if (!from.contains(key)) {
        return;
    }
    try {
        read(from.at(key));
    } catch (const InputError &error) {
        throw InputError("{}: {}: {}", name, key, error.what());
    } catch (const ordered_json::exception &) {
        throw InputError("{}: {}: unexpected value {}", name, key, short_json(from.at(key)));
    }
}

double read_share(double value) {
    if (!(value >= 0 && value <= 1)) {
        throw InputError("expected a number from 0 to 1");
    }
    return value;
}

Size read_size(const ordered_json &value) {
    const auto side = [&](std::size_t i) { // beyond what check_size() accepts, whatever an int would make of it
        const auto number = value.at(i).get<double>();
        return number == std::trunc(number) ? static_cast<int>(std::clamp(number, -1.0, 1e9)) : -1;
    };
    const Size size{side(0), side(1)};
    check_size(size);
    return size;
}

FlipSide parse_flip(std::string_view text) {
    if (text != "A" && text != "B") {
        throw InputError("expected A or B, got '{}'", text);
    }
    return text == "A" ? FlipSide::a : FlipSide::b;
}

void write_marks(ordered_json &out, const Marks &marks) {
    if (marks.pixel) {
        out["pixel"] = {marks.pixel->x, marks.pixel->y};
    }
    for (const auto &[key, on] : {std::pair("vectors", marks.vectors), std::pair("loupe", marks.loupe)}) {
        if (on) {
            out[key] = true;
        }
    }
    if (marks.profile) {
        out["profile"] = *marks.profile;
    }
    if (marks.ring) {
        out["ring"] = {marks.ring->x, marks.ring->y, marks.ring->z};
    }
}

void read_techniques(const ordered_json &value, const std::filesystem::path &folder, PictureOptions &options) {
    options.left = technique_of(value.at(0), folder);
    options.right = value.size() > 1 ? technique_of(value.at(1), folder) : options.left;
}

} // namespace

std::filesystem::path sidecar_path(const std::filesystem::path &picture) {
    std::filesystem::path path = picture;
    path += ".json";
    return path;
}

std::string sidecar_text(const Scene &scene, const PictureOptions &options, const DrawnBy &by,
                         const std::filesystem::path &folder) {
    ordered_json techniques = ordered_json::array({technique_json(options.left, folder)});
    if (options.layout != Layout::single || options.flip != FlipSide::none) {
        techniques.push_back(technique_json(options.right, folder));
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
    if (options.language != languages.front()) {
        out["language"] = options.language;
    }
    if (options.textbook_left) {
        out["textbook_left"] = true;
    }
    if (options.mesh_factors != MeshFactors{1, 1}) {
        out["mesh_factors"] = options.mesh_factors;
    }
    if (options.samples != 1) {
        out["samples"] = options.samples;
    }
    for (const OverlayKind &kind : overlay_kinds) {
        if (options.drawn_over.*kind.on) {
            out[std::string(kind.word)] = true;
        }
    }
    if (options.masks) {
        out["masks"] = true;
    }
    if (options.flip != FlipSide::none) {
        out["flip"] = options.flip == FlipSide::a ? "A" : "B";
    }
    if (options.layout == Layout::difference) {
        out["difference_of"] = to_string(options.difference_of);
    }
    if (options.layout == Layout::wipe) {
        out["divider"] = options.divider;
    }
    write_marks(out, options.marks);
    if (!options.view.empty()) {
        out["view"] = options.view;
    }
    out["scene"] = ordered_json::parse(scene_text(scene, folder));
    return out.dump(2) + "\n";
}

std::string with_keys(std::string_view sidecar, std::string_view more) {
    auto json = ordered_json::parse(sidecar);
    const ordered_json scene = json.at("scene");
    json.erase("scene");
    json.update(ordered_json::parse(more));
    json["scene"] = scene;
    return json.dump(2) + "\n";
}

std::optional<PictureOptions> sidecar_options(std::string_view text, std::string_view name,
                                              const std::filesystem::path &folder) {
    const ordered_json from = sidecar_json(text, name);
    if (!from.contains("techniques")) {
        return std::nullopt;
    }
    PictureOptions options;
    const auto read = [&](const char *key, auto reader) { read_key(from, key, name, reader); };
    const auto read_value = [&]<typename Value>(const char *key, Value &value) {
        read(key, [&](const ordered_json &v) { value = v.get<Value>(); });
    };
    read("layout", [&](const ordered_json &v) { options.layout = parse_layout(v.get<std::string>()); });
    read("techniques", [&](const ordered_json &v) { read_techniques(v, folder, options); });
    read("size", [&](const ordered_json &v) { options.size = read_size(v); });
    read("display", [&](const ordered_json &v) { options.display = parse_display(v.get<std::string>()); });
    read("divider", [&](const ordered_json &v) { options.divider = read_share(v.get<double>()); });
    read("flip", [&](const ordered_json &v) { options.flip = parse_flip(v.get<std::string>()); });
    read("difference_of",
         [&](const ordered_json &v) { options.difference_of = parse_difference_of(v.get<std::string>()); });
    read("pixel", [&](const ordered_json &v) {
        options.marks.pixel = {read_share(v.at(0).get<double>()), read_share(v.at(1).get<double>())};
    });
    read("profile", [&](const ordered_json &v) { options.marks.profile = read_share(v.get<double>()); });
    read("ring", [&](const ordered_json &v) {
        const auto share_at = [&](std::size_t i) { return read_share(v.at(i).get<double>()); };
        options.marks.ring = {share_at(0), share_at(1), share_at(2)};
    });
    read("mesh_factors", [&](const ordered_json &v) {
        options.mesh_factors = {checked_mesh_factor(v.at(0).get<double>()), checked_mesh_factor(v.at(1).get<double>())};
    });
    read("samples", [&](const ordered_json &v) { options.samples = checked_samples(v.get<double>()); });
    read_value("vectors", options.marks.vectors);
    read_value("loupe", options.marks.loupe);
    for (const OverlayKind &kind : overlay_kinds) {
        read_value(std::string(kind.word).c_str(), options.drawn_over.*kind.on);
    }
    read_value("masks", options.masks);
    read_value("textbook_left", options.textbook_left);
    read("exposure",
         [&](const ordered_json &v) { options.exposure = checked_number(v.get<double>(), exposure_range); });
    read("gain", [&](const ordered_json &v) { options.gain = checked_number(v.get<double>(), gain_range); });
    read_value("labels", options.labels);
    read("language", [&](const ordered_json &v) { options.language = checked_language(v.get<std::string>()); });
    read_value("view", options.view);
    return options;
}

} // namespace sandbox
