#include "scene/scene_read.h"

#include "image/error.h"
#include "scene/scene_format.h"
#include "scene/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace sandbox {
namespace {

/// 1e9 rather than 1e+09.
std::string number_text(double value) {
    const double power = std::log10(value);
    return value >= 1e5 && power == std::floor(power) ? fmt::format("1e{:.0f}", power) : fmt::format("{:.9g}", value);
}

/// What is wrong with a number, as `<noun> >= 0`; empty: nothing.
std::string broken_rule(double value, const Range &range, std::string_view noun) {
    const bool low = range.above_low ? !(value > range.low) : !(value >= range.low);
    if (value == range.or_exactly || (!low && value <= range.high)) {
        return {};
    }
    if (!std::isnan(range.or_exactly)) {
        return fmt::format("{} from {} to {}, or {}", noun, number_text(range.low), number_text(range.high),
                           number_text(range.or_exactly));
    }
    return low ? fmt::format("{} {} {}", noun, range.above_low ? ">" : ">=", number_text(range.low))
               : fmt::format("{} <= {}", noun, number_text(range.high));
}

std::string got(const Json &json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > 60) {
        text = json.is_array() ? fmt::format("an array of {}", json.size()) : text.substr(0, 57) + "...";
    }
    return ", got " + text;
}

std::string below(const std::string &path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}
std::string element(const std::string &path, std::size_t index) { return fmt::format("{}[{}]", path, index); }

template <class S> constexpr bool is_built_in_shape = !std::is_same_v<S, ObjShape>;

std::vector<std::string_view> built_in_shapes() {
    std::vector<std::string_view> names;
    for_each_shape([&]<class S>(std::type_identity<S>) {
        if (is_built_in_shape<S>) {
            names.push_back(format_of<S>.name);
        }
    });
    return names;
}

class Reader {
  public:
    Reader(std::string_view name, std::filesystem::path folder) : name_(name), folder_(std::move(folder)) {}

    /// `extra`: a key that is no field of T.
    template <class T>
    void read_object(const Json &json, const std::string &path, T &out, std::string_view extra = {}) const {
        expect(json.is_object(), path, "an object", json);
        check_keys<T>(json, path, extra);
        for_each_field<T>([&](const auto &field) { read_field(json, path, field, out); });
        finish(json, path, out);
    }

  private:
    std::string name_;
    std::filesystem::path folder_;

    [[noreturn]] void refuse(const std::string &path, const std::string &what) const {
        throw InputError("{}: {}{}{}", name_, path, path.empty() ? "" : ": ", what);
    }
    void expect(bool good, const std::string &path, const std::string &what, const Json &json) const {
        if (!good) {
            refuse(path, json.is_discarded() ? "missing; expected " + what : "expected " + what + got(json));
        }
    }

    template <class T> void check_keys(const Json &json, const std::string &path, std::string_view extra) const {
        std::vector<std::string_view> known;
        if (!extra.empty()) {
            known.push_back(extra);
        }
        for_each_field<T>([&](const auto &field) { known.push_back(field.key); });
        for (const auto &[key, value] : json.items()) {
            if (std::ranges::find(known, key) == known.end()) {
                refuse(below(path, key.substr(0, 60)),
                       fmt::format("unknown key of this {}{}", format_of<T>.name, suggestion(key, known)));
            }
        }
    }

    template <class T, class M>
    void read_field(const Json &json, const std::string &path, const Field<T, M> &field, T &out) const {
        const Json missing(Json::value_t::discarded); // nothing expects it
        if (const auto found = json.find(field.key); found != json.end() || field.rules.needed(out)) {
            read(found != json.end() ? *found : missing, below(path, field.key), field.range, out.*field.member);
        }
    }

    static std::string one_of(const auto &words) {
        std::string list;
        for (const std::string_view word : words) {
            list += fmt::format("{}\"{}\"", list.empty() ? "one of " : ", ", word);
        }
        return list;
    }

    /// double or int
    template <class Number>
    void read(const Json &json, const std::string &path, const Range &range,
              Number &out) const requires std::is_arithmetic_v<Number> {
        const bool whole = std::is_integral_v<Number>;
        const std::string noun = whole ? "a whole number" : "a number";
        const double value = json.is_number() ? json.get<double>() : no_number;
        expect(std::isfinite(value) && (!whole || std::trunc(value) == value), path, noun, json);
        const std::string rule = broken_rule(value, range, noun);
        expect(rule.empty(), path, rule, json);
        out = static_cast<Number>(value);
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
        const auto *kind = std::ranges::find_if(light_kinds, [&](const LightKind &k) { return json == k.word; });
        std::array<std::string_view, light_kinds.size()> words;
        std::ranges::transform(light_kinds, words.begin(), &LightKind::word);
        expect(kind != light_kinds.end(), path, one_of(words), json);
        out = kind->type;
    }
    template <class E>
    void read(const Json &json, const std::string &path, const Range &, E &out) const requires HasWords<E> {
        const auto found = std::ranges::find_if(words_of<E>, [&](std::string_view word) { return json == word; });
        expect(found != words_of<E>.end(), path, one_of(words_of<E>), json);
        out = static_cast<E>(found - words_of<E>.begin());
    }
    template <int N>
    void read(const Json &json, const std::string &path, const Range &range, glm::vec<N, double> &out) const {
        expect(json.is_array() && json.size() == N, path, fmt::format("an array of {} numbers", N), json);
        for (int i = 0; i < N; ++i) {
            const auto at = static_cast<std::size_t>(i);
            read(json[at], element(path, at), range, out[i]);
        }
        expect(!range.a_direction || out != glm::vec<N, double>(0), path, "a vector other than (0, 0, 0)", json);
    }
    template <std::size_t N>
    void read(const Json &json, const std::string &path, const Range &range, std::array<glm::dvec3, N> &out) const {
        expect(json.is_array() && json.size() == N, path, fmt::format("an array of {} colours", N), json);
        for (std::size_t i = 0; i < N; ++i) {
            read(json[i], element(path, i), range, out[i]);
        }
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &range, std::vector<T> &out) const {
        expect(json.is_array(), path, "an array", json);
        if (static_cast<double>(json.size()) > range.high) {
            refuse(path, fmt::format("expected at most {} elements, got {}", number_text(range.high), json.size()));
        }
        out.assign(json.size(), T{});
        for (std::size_t i = 0; i < json.size(); ++i) {
            read(json[i], element(path, i), any, out[i]);
        }
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &, std::optional<T> &out) const {
        read_object(json, path, out.emplace());
    }
    void read(const Json &json, const std::string &path, const Range &, Shape &out) const {
        expect(json.is_object(), path, "an object with \"shape\" or \"obj\"", json);
        const bool from_file = json.contains("obj");
        if (!from_file) {
            check_shape_word(json, path);
        }
        for_each_shape([&]<class S>(std::type_identity<S>) {
            if (from_file ? !is_built_in_shape<S> : json["shape"] == format_of<S>.name) {
                read_object(json, path, out.emplace<S>(), is_built_in_shape<S> ? "shape" : "");
            }
        });
    }
    template <class T>
    void read(const Json &json, const std::string &path, const Range &, T &out) const requires HasFormat<T> {
        read_object(json, path, out);
    }

    void check_shape_word(const Json &json, const std::string &path) const {
        if (!json.contains("shape")) {
            constexpr std::array<std::string_view, 2> known{"shape", "obj"};
            for (const auto &[key, value] : json.items()) { // misspelt, probably
                if (!nearest_word(key, known).empty()) {
                    refuse(below(path, key), "unknown key of this mesh" + suggestion(key, known));
                }
            }
            refuse(path, R"(expected "shape" or "obj")" + got(json));
        }
        const Json &shape = json["shape"];
        expect(shape.is_string(), below(path, "shape"), "a string", shape);
        const auto names = built_in_shapes();
        if (const auto &word = shape.get_ref<const std::string &>(); std::ranges::find(names, word) == names.end()) {
            refuse(below(path, "shape"), "unknown shape" + got(shape) + suggestion(word, names));
        }
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
            refuse(below(path, "inner_cutoff_degrees"),
                   fmt::format("expected at most cutoff_degrees ({}){}", number_text(light.cutoff_degrees),
                               got(json["inner_cutoff_degrees"])));
        }
    }
    void finish(const Json &json, const std::string &path, Camera &camera) const {
        if (!(camera.near_plane < camera.far_plane)) {
            refuse(below(path, json.contains("far") ? "far" : "near"),
                   fmt::format("expected near < far, got near {}, far {}", number_text(camera.near_plane),
                               number_text(camera.far_plane)));
        }
        if (camera.target == camera.position) {
            refuse(below(path, "target"), "expected a point other than the camera's position");
        }
        if (is_orthographic(camera) && json.contains("fov_y_degrees")) {
            refuse(below(path, "fov_y_degrees"), "expected height in its place beside projection orthographic");
        }
        if (is_perspective(camera) && json.contains("height")) {
            refuse(below(path, "height"), "expected fov_y_degrees in its place beside projection perspective");
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
        for (auto view = scene.views.begin(); view != scene.views.end(); ++view) {
            if (std::find_if(scene.views.begin(), view, [&](const View &v) { return v.name == view->name; }) != view) {
                const auto i = static_cast<std::size_t>(view - scene.views.begin());
                refuse(below(element(below(path, "views"), i), "name"),
                       fmt::format("expected a name of its own, got \"{}\" again", view->name));
            }
        }
    }
};

} // namespace

Scene read_scene(const Json &json, std::string_view name, const std::filesystem::path &folder) {
    Scene scene;
    Reader(name, folder).read_object(json, "", scene, "$schema"); // which is for editors
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
