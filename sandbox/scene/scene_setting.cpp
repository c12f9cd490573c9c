#include "scene/scene_setting.h"

#include "image/error.h"
#include "image/plain_text.h"
#include "scene/orbit.h"
#include "scene/read_json.h"
#include "scene/scene_read.h"
#include "scene/scene_write.h"
#include "scene/suggest.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

/// One `PATH=VALUE`; `label` names it in messages.
class Setting {
  public:
    Setting(std::string_view path, std::string label) : path_(path), rest_(path), label_(std::move(label)) {}

    /// A texture or model is looked for in `folder`.
    void apply(Json &scene, std::string_view text, const std::filesystem::path &folder) {
        Json *parent = nullptr;
        Json *at = &scene;
        std::string key; ///< the last step; empty: an index
        while (at == &scene || !rest_.empty()) {
            parent = at;
            key = rest_.starts_with('[') ? "" : take_key();
            at = key.empty() ? &element(*at, take_index()) : &member(*at, key);
        }
        Json value = at->is_string() && !text.starts_with('"') ? Json(text) : parse_value(text); // name=5 is a text
        if ((key == "texture" || key == "obj") && value.is_string()) {
            value = resolve_path(value.get<std::string>(), folder);
        }
        if (key == "projection" && at->is_string() && *at != value) {
            keep_size(*parent);
        }
        if (key == "shape" || key == "obj") { // another shape has other keys
            *parent = Json::object({{key, std::move(value)}});
        } else {
            *at = std::move(value);
        }
    }

  private:
    std::string_view path_;
    std::string_view rest_; ///< of the path
    std::string label_;

    /// The other projection says in another key how much it shows; what is seen at the target stays.
    static void keep_size(Json &camera) {
        const bool perspective = camera.contains("fov_y_degrees");
        Camera before;
        try {
            for (int i = 0; i < 3; ++i) {
                before.position[i] = camera.at("position").at(static_cast<std::size_t>(i)).get<double>();
                before.target[i] = camera.at("target").at(static_cast<std::size_t>(i)).get<double>();
            }
            before.projection = perspective ? Projection::perspective : Projection::orthographic;
            (perspective ? before.fov_y_degrees : before.height) =
                camera.at(perspective ? "fov_y_degrees" : "height").get<double>();
        } catch (const Json::exception &) {
            return; // the reader says what is wrong
        }
        const Camera after = with_projection(before, perspective ? Projection::orthographic : Projection::perspective);
        camera.erase(perspective ? "fov_y_degrees" : "height");
        camera[perspective ? "height" : "fov_y_degrees"] = perspective ? after.height : after.fov_y_degrees;
    }

    [[noreturn]] void refuse(const std::string &what) const { throw InputError("{}: {}", label_, what); }

    /// JSON, or a bare word as a string.
    [[nodiscard]] Json parse_value(std::string_view text) const {
        try {
            return read_json<Json>(text, label_);
        } catch (const InputError &) {
            if (text.starts_with('[') || text.starts_with('{') || text.starts_with('"')) {
                throw;
            }
            return std::string(text);
        }
    }

    /// Of "[0]", with which the rest begins.
    std::size_t take_index() {
        std::size_t index = 0;
        const std::size_t end = rest_.find(']');
        const char *stop = rest_.data() + std::min(end, rest_.size());
        const auto [parsed, error] = std::from_chars(rest_.data() + 1, stop, index);
        if (end == std::string_view::npos || error != std::errc() || parsed != stop) {
            refuse("expected an index such as [0]");
        }
        rest_.remove_prefix(end + 1);
        return index;
    }

    /// Of "key" or, behind another step, ".key".
    std::string take_key() {
        const bool first = rest_.size() == path_.size();
        const std::size_t begin = first ? 0 : 1;
        std::string key(rest_.substr(begin, rest_.find_first_of(".[", begin) - begin));
        if (key.empty() || (!first && rest_.front() != '.')) {
            refuse("expected a path such as lights[0].diffuse");
        }
        rest_.remove_prefix(begin + key.size());
        return key;
    }

    [[nodiscard]] Json &element(Json &json, std::size_t index) const {
        if (!json.is_array()) {
            refuse(fmt::format("[{}] needs an array, and this is none", index));
        }
        if (index >= json.size()) {
            refuse(fmt::format("index {} is out of range; there are {}", index, json.size()));
        }
        return json[index];
    }

    /// A key that is not there yet (a checker's) is made; the reader refuses what the format does not know.
    [[nodiscard]] Json &member(Json &json, const std::string &key) const {
        if (!json.is_object() && !json.is_null()) {
            refuse(fmt::format("\"{}\" needs an object, and this is none", key));
        }
        if (rest_.starts_with('[') && !json.contains(key)) {
            std::vector<std::string_view> known;
            for (const auto &[name, value] : json.items()) {
                known.push_back(json.find(name).key());
            }
            refuse(fmt::format("unknown key \"{}\"{}", key, suggestion(key, known)));
        }
        return json[key];
    }
};

/// A model that was read for the scene is not read again for what differs in a setting.
void keep_meshes(const Scene &from, Scene &to) {
    for (std::size_t i = 0; i < std::min(from.objects.size(), to.objects.size()); ++i) {
        const auto *before = std::get_if<ObjShape>(&from.objects[i].mesh);
        auto *now = std::get_if<ObjShape>(&to.objects[i].mesh);
        if (before != nullptr && now != nullptr && *before == *now) {
            now->mesh = before->mesh;
        }
    }
}

} // namespace

bool names_file(std::string_view path) { return path.ends_with("texture") || path.ends_with("obj"); }

Scene with_settings(const Scene &scene, std::span<const std::string> settings, std::string_view name,
                    const std::filesystem::path &folder) {
    Json json = write_scene(scene, Keys::all);
    Scene changed = scene;
    bool names_files = false;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const std::string_view setting = settings[i];
        const std::size_t equals = setting.find('=');
        const std::string_view path = setting.substr(0, equals);
        const std::string label = fmt::format("{} {}", name, path);
        if (!is_utf8(setting)) { // no file could hold it
            throw InputError("{}: expected text in UTF-8", plain_text(label));
        }
        if (equals == std::string_view::npos) {
            throw InputError(label + ": expected PATH=VALUE, such as lights[0].diffuse=0.5");
        }
        Setting(path, label).apply(json, setting.substr(equals + 1), folder);
        names_files = names_files || names_file(path);
        try {
            changed = read_scene(json, name, {});
            json = write_scene(changed, Keys::all); // a new shape has its other keys for the next setting
        } catch (const InputError &) { // which the next one may put right: a camera's position, then its up
            if (i + 1 == settings.size()) {
                throw;
            }
        }
    }
    changed.looked_in = names_files ? LookedIn{folder.string()} : scene.looked_in;
    keep_meshes(scene, changed);
    return changed;
}

Scene with_setting(const Scene &scene, std::string_view path_equals_value) {
    const std::string setting(path_equals_value);
    return with_settings(scene, {&setting, 1}, "--set", std::filesystem::current_path());
}

} // namespace sandbox
