#include "scene/scene_write.h"

#include "scene/scene_format.h"

#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

class Writer {
  public:
    explicit Writer(Keys keys) : keys_(keys) {}

    template <class T> OrderedJson object(const T &value) const {
        OrderedJson json = OrderedJson::object();
        add_fields(json, value);
        return json;
    }

  private:
    Keys keys_;

    template <class T> void add_fields(OrderedJson &json, const T &value) const {
        for_each_field<T>([&](const auto &field) {
            const auto &member = value.*field.member;
            const bool written = keys_ == Keys::all || field.rules.needed(value) || member != T{}.*field.member;
            if (special(value, field.key).value_or(written)) {
                json[std::string(field.key)] = write(member);
            }
        });
    }

    /// Keys whose absence does not mean the struct's default: written or not whatever `keys` says.
    template <class T> static std::optional<bool> special(const T &, std::string_view) { return std::nullopt; }
    static std::optional<bool> special(const Light &light, std::string_view key) {
        return key == "inner_cutoff_degrees" ? std::optional(light.inner_cutoff_degrees != light.cutoff_degrees)
                                             : std::nullopt;
    }
    static std::optional<bool> special(const Camera &camera, std::string_view key) {
        return key == (is_orthographic(camera) ? "fov_y_degrees" : "height") ? std::optional(false) : std::nullopt;
    }
    static std::optional<bool> special(const Material &material, std::string_view key) {
        return key == "checker" ? std::optional(material.checker.has_value()) : std::nullopt;
    }
    static std::optional<bool> special(const ObjShape &obj, std::string_view key) {
        return key == "usemtl" ? std::optional(obj.usemtl.has_value()) : std::nullopt;
    }
    static std::optional<bool> special(const Scene &scene, std::string_view key) {
        return key == "compare" ? std::optional(scene.compare != Opening{}) : std::nullopt;
    }
    static std::optional<bool> special(const Opening &opening, std::string_view key) {
        return !(key == "left" ? opening.left : key == "right" ? opening.right : opening.layout).empty();
    }

    template <class T> static OrderedJson write(const T &value) { return value; }
    static OrderedJson write(LightType value) { return std::string(kind_of(value).word); }
    template <class E> static OrderedJson write(const E &value) requires HasWords<E> {
        return std::string(words_of<E>[static_cast<std::size_t>(value)]);
    }
    template <int N> static OrderedJson write(const glm::vec<N, double> &value) {
        OrderedJson json = OrderedJson::array();
        for (int i = 0; i < N; ++i) {
            json.push_back(value[i]);
        }
        return json;
    }
    template <class T> OrderedJson list(const T &values) const {
        OrderedJson json = OrderedJson::array();
        for (const auto &value : values) {
            json.push_back(write(value));
        }
        return json;
    }
    template <std::size_t N> OrderedJson write(const std::array<glm::dvec3, N> &colors) const { return list(colors); }
    template <class T> OrderedJson write(const std::vector<T> &values) const { return list(values); }
    template <class T> OrderedJson write(const std::optional<T> &value) const { return object(*value); }
    static OrderedJson write(const std::optional<std::string> &value) { return *value; }
    OrderedJson write(const Shape &shape) const {
        return std::visit(
            [&]<class S>(const S &value) {
                OrderedJson json = OrderedJson::object();
                if constexpr (!std::is_same_v<S, ObjShape>) {
                    json["shape"] = std::string(format_of<S>.name);
                }
                add_fields(json, value);
                return json;
            },
            shape);
    }
    template <class T> OrderedJson write(const T &value) const requires HasFormat<T> { return object(value); }
};

} // namespace

OrderedJson write_scene(const Scene &scene, Keys keys) { return Writer(keys).object(scene); }

} // namespace sandbox
