#include "scene/scene_json.h"

#include "image/error.h"
#include "scene/scene_format.h"
#include "scene/suggest.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

namespace sandbox {
namespace {

/// 1e9 rather than 1e+09.
std::string number_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    std::string out(text.data());
    if (const double power = std::log10(value); value >= 1e5 && power == std::floor(power)) {
        out = "1e" + std::to_string(static_cast<int>(power));
    }
    return out;
}

/// What is wrong with a number, as `<noun> >= 0`; empty: nothing.
std::string broken_rule(double value, const Range &range, const std::string &noun) {
    if (value == range.or_exactly) {
        return {};
    }
    const bool low = range.above_low ? !(value > range.low) : !(value >= range.low);
    if (!low && value <= range.high) {
        return {};
    }
    if (!std::isnan(range.or_exactly)) {
        return noun + " from " + number_text(range.low) + " to " + number_text(range.high) + ", or " +
               number_text(range.or_exactly);
    }
    return low ? noun + (range.above_low ? " > " : " >= ") + number_text(range.low)
               : noun + " <= " + number_text(range.high);
}

std::string got(const Json &json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > 60) {
        text = json.is_array() ? "an array of " + std::to_string(json.size()) : text.substr(0, 57) + "...";
    }
    return ", got " + text;
}

class Reader {
  public:
    Reader(std::string_view name, std::filesystem::path folder) : name_(name), folder_(std::move(folder)) {}

    template <class T> void read_object(const Json &json, const std::string &path, T &out) const {
        expect(json.is_object(), path, "an object", json);
        check_keys<T>(json, path, std::is_same_v<T, Scene> ? "$schema" : "");
        for_each_field<T>([&](const auto &field) { read_field(json, path, field, out); });
        finish(json, path, out);
    }

  private:
    std::string name_;
    std::filesystem::path folder_;

    [[noreturn]] void refuse(const std::string &path, const std::string &what) const {
        throw InputError(name_ + ": " + (path.empty() ? "" : path + ": ") + what);
    }
    void expect(bool good, const std::string &path, const std::string &what, const Json &json) const {
        if (!good) {
            refuse(path, "expected " + what + got(json));
        }
    }
    static std::string below(const std::string &path, std::string_view key) {
        return path.empty() ? std::string(key) : path + "." + std::string(key);
    }
    static std::string element(const std::string &path, std::size_t index) {
        return path + "[" + std::to_string(index) + "]";
    }

    /// `extra`: a key that is no field of T ("shape"; "$schema", which is for editors).
    template <class T> void check_keys(const Json &json, const std::string &path, std::string_view extra) const {
        std::vector<std::string_view> known;
        if (!extra.empty()) {
            known.push_back(extra);
        }
        for_each_field<T>([&](const auto &field) { known.push_back(field.key); });
        for (const auto &[key, value] : json.items()) {
            if (std::find(known.begin(), known.end(), key) == known.end()) {
                refuse(below(path, key.substr(0, 60)),
                       "unknown key of this " + std::string(Format<T>::name) + suggestion(key, known));
            }
        }
    }

    template <class T, class M>
    void read_field(const Json &json, const std::string &path, const Field<T, M> &field, T &out) const {
        const std::string here = below(path, field.key);
        if (const auto found = json.find(field.key); found != json.end()) {
            read(*found, here, field.range, out.*field.member);
        } else if (field.needed(out)) {
            refuse(here, "missing; expected " + what_is_expected(out.*field.member));
        }
    }

    static std::string what_is_expected(const LightType &) { return light_type_list(); }
    static std::string what_is_expected(const glm::dvec3 &) { return "an array of 3 numbers"; }
    static std::string what_is_expected(const std::string &) { return "a string"; }
    template <class T> static std::string what_is_expected(const T &) { return "an object"; }

    static std::string light_type_list() {
        std::string list;
        for (const LightWord &word : light_words) {
            list += (list.empty() ? "\"" : ", \"") + std::string(word.word) + "\"";
        }
        return "one of " + list;
    }

    void read(const Json &json, const std::string &path, const Range &range, double &out) const {
        expect(json.is_number() && std::isfinite(json.get<double>()), path, "a number", json);
        const double value = json.get<double>();
        const std::string rule = broken_rule(value, range, "a number");
        expect(rule.empty(), path, rule, json);
        out = value;
    }
    void read(const Json &json, const std::string &path, const Range &range, int &out) const {
        const bool whole = json.is_number() && std::trunc(json.get<double>()) == json.get<double>();
        expect(whole, path, "a whole number", json);
        const double value = json.get<double>();
        const std::string rule = broken_rule(value, range, "a whole number");
        expect(rule.empty(), path, rule, json);
        out = static_cast<int>(value);
    }
    void read(const Json &json, const std::string &path, const Range &, bool &out) const {
        expect(json.is_boolean(), path, "true or false", json);
        out = json.get<bool>();
    }
    void read(const Json &json, const std::string &path, const Range &, std::string &out) const {
        expect(json.is_string(), path, "a string", json);
        out = json.get<std::string>();
    }
    void read(const Json &json, const std::string &path, const Range &, LightType &out) const {
        for (const LightWord &word : light_words) {
            if (json == word.word) {
                out = word.type;
                return;
            }
        }
        expect(false, path, light_type_list(), json);
    }
    template <int N>
    void read(const Json &json, const std::string &path, const Range &range, glm::vec<N, double> &out) const {
        expect(json.is_array() && json.size() == N, path, "an array of " + std::to_string(N) + " numbers", json);
        for (int i = 0; i < N; ++i) {
            const auto at = static_cast<std::size_t>(i);
            read(json[at], element(path, at), range, out[i]);
        }
        expect(!range.a_direction || out != glm::vec<N, double>(0), path, "a vector other than (0, 0, 0)", json);
    }
    void read(const Json &json, const std::string &path, const Range &range, std::array<glm::dvec3, 2> &out) const {
        expect(json.is_array() && json.size() == 2, path, "an array of 2 colours", json);
        for (std::size_t i = 0; i < 2; ++i) {
            read(json[i], element(path, i), range, out[i]);
        }
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &range, std::vector<T> &out) const {
        expect(json.is_array(), path, "an array", json);
        if (static_cast<double>(json.size()) > range.high) {
            refuse(path,
                   "expected at most " + number_text(range.high) + " elements, got " + std::to_string(json.size()));
        }
        out.clear();
        for (std::size_t i = 0; i < json.size(); ++i) {
            T value;
            read(json[i], element(path, i), any, value);
            out.push_back(std::move(value));
        }
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &, std::optional<T> &out) const {
        T value;
        read_object(json, path, value);
        out = std::move(value);
    }
    void read(const Json &json, const std::string &path, const Range &, Shape &out) const {
        read_shape(json, path, out);
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &, T &out) const requires HasFormat<T> {
        read_object(json, path, out);
    }

    void read_shape(const Json &json, const std::string &path, Shape &out) const {
        expect(json.is_object(), path, "an object with \"shape\" or \"obj\"", json);
        if (json.contains("obj")) {
            ObjShape obj;
            read_object(json, path, obj);
            out = obj;
            return;
        }
        std::vector<std::string_view> names;
        for_each_shape([&]<class S>(std::type_identity<S>) {
            if constexpr (!std::is_same_v<S, ObjShape>) {
                names.push_back(Format<S>::name);
            }
        });
        if (!json.contains("shape")) {
            check_mesh_keys(json, path);
            refuse(path, R"(expected "shape" or "obj")" + got(json));
        }
        const Json &shape = json["shape"];
        expect(shape.is_string(), below(path, "shape"), "a string", shape);
        const auto &word = shape.get_ref<const std::string &>();
        bool found = false;
        for_each_shape([&]<class S>(std::type_identity<S>) {
            if constexpr (!std::is_same_v<S, ObjShape>) {
                if (word == Format<S>::name) {
                    out = read_built_in<S>(json, path);
                    found = true;
                }
            }
        });
        if (!found) {
            refuse(below(path, "shape"), "unknown shape" + got(shape) + suggestion(word, names));
        }
    }

    /// A misspelt "shape" is the likeliest reason for its absence.
    void check_mesh_keys(const Json &json, const std::string &path) const {
        constexpr std::array<std::string_view, 2> known{"shape", "obj"};
        for (const auto &[key, value] : json.items()) {
            if (!nearest_word(key, known).empty()) {
                refuse(below(path, key), "unknown key of this mesh" + suggestion(key, known));
            }
        }
    }

    template <class S> S read_built_in(const Json &json, const std::string &path) const {
        S shape;
        check_keys<S>(json, path, "shape");
        for_each_field<S>([&](const auto &field) { read_field(json, path, field, shape); });
        return shape;
    }

    // Rules that tie several keys together.
    template <class T> void finish(const Json &, const std::string &, T &) const {}
    void finish(const Json &json, const std::string &path, Attenuation &a) const {
        expect(a.constant > 0 || a.linear > 0 || a.quadratic > 0, path, "a coefficient above 0", json);
    }
    void finish(const Json &json, const std::string &path, Light &light) const {
        if (!json.contains("inner_cutoff_degrees")) {
            light.inner_cutoff_degrees = light.cutoff_degrees;
        }
        if (light.inner_cutoff_degrees > light.cutoff_degrees) {
            refuse(below(path, "inner_cutoff_degrees"), "expected at most cutoff_degrees (" +
                                                            number_text(light.cutoff_degrees) + ")" +
                                                            got(json["inner_cutoff_degrees"]));
        }
    }
    void finish(const Json &json, const std::string &path, Camera &camera) const {
        if (!(camera.near_plane < camera.far_plane)) {
            refuse(below(path, json.contains("far") ? "far" : "near"), "expected near < far, got near " +
                                                                           number_text(camera.near_plane) + ", far " +
                                                                           number_text(camera.far_plane));
        }
        if (camera.target == camera.position) {
            refuse(below(path, "target"), "expected a point other than the camera's position");
        }
    }
    void finish(const Json &, const std::string &path, Material &material) const {
        material.texture = resolve_path(material.texture, folder_);
        if (material.checker && !material.texture.empty()) {
            refuse(below(path, "checker"), "expected checker or texture, got both");
        }
    }
    void finish(const Json &, const std::string &path, ObjShape &obj) const {
        if (obj.path.empty()) {
            refuse(below(path, "obj"), "expected a path, got \"\"");
        }
        obj.path = resolve_path(obj.path, folder_);
    }
    void finish(const Json &, const std::string &path, Scene &scene) const {
        for (std::size_t i = 0; i < scene.views.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (scene.views[i].name == scene.views[j].name) {
                    refuse(below(element(below(path, "views"), i), "name"),
                           "expected a name of its own, got \"" + scene.views[i].name + "\" again");
                }
            }
        }
    }
};

} // namespace

Scene read_scene(const Json &json, std::string_view name, const std::filesystem::path &folder) {
    Scene scene;
    Reader(name, folder).read_object(json, "", scene);
    return scene;
}

std::string resolve_path(const std::string &path, const std::filesystem::path &folder) {
    namespace fs = std::filesystem;
    const fs::path given(path);
    if (path.empty() || given.is_absolute()) {
        return path;
    }
    std::error_code ignored;
    const bool bare = !given.has_parent_path();
    if (bare && (folder.empty() || !fs::exists(folder / given, ignored))) {
        return path;
    }
    return fs::absolute(folder / given).lexically_normal().string();
}

} // namespace sandbox
