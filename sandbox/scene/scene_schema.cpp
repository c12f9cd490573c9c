#include "scene/scene_schema.h"

#include "scene/scene_format.h"
#include "scene/scene_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

OrderedJson reference(std::string_view name) { return {{"$ref", "#/definitions/" + std::string(name)}}; }

OrderedJson number(std::string_view type, const Range &range) {
    OrderedJson json{{"type", std::string(type)}};
    if (std::isfinite(range.low)) {
        json[range.above_low ? "exclusiveMinimum" : "minimum"] = range.low;
    }
    if (std::isfinite(range.high)) {
        json["maximum"] = range.high;
    }
    if (!std::isnan(range.or_exactly)) {
        return {{"anyOf", OrderedJson::array({json, {{"const", range.or_exactly}}})}};
    }
    return json;
}

OrderedJson array_of(OrderedJson items, std::size_t low, double high) {
    OrderedJson json{{"type", "array"}, {"items", std::move(items)}};
    if (low > 0) {
        json["minItems"] = low;
    }
    if (std::isfinite(high)) {
        json["maxItems"] = high;
    }
    return json;
}

/// The type of a key and, where it is plain, its default.
template <class Number> OrderedJson type_of(Number value, const Range &range) requires std::is_arithmetic_v<Number> {
    OrderedJson json = number(std::is_integral_v<Number> ? "integer" : "number", range);
    json["default"] = value;
    return json;
}
OrderedJson type_of(bool value, const Range &) { return {{"type", "boolean"}, {"default", value}}; }
OrderedJson type_of(const std::string &, const Range &) { return {{"type", "string"}}; }
OrderedJson type_of(LightType, const Range &) {
    OrderedJson words = OrderedJson::array();
    for (const LightKind &kind : light_kinds) {
        words.push_back(std::string(kind.word));
    }
    return {{"enum", words}};
}
template <class E> OrderedJson type_of(const E &value, const Range &) requires HasWords<E> {
    OrderedJson words = OrderedJson::array();
    for (const std::string_view word : words_of<E>) {
        words.push_back(std::string(word));
    }
    return {{"enum", words}, {"default", words[static_cast<std::size_t>(value)]}};
}
template <int N> OrderedJson type_of(const glm::vec<N, double> &value, const Range &range) {
    OrderedJson json = array_of(number("number", range), N, N);
    for (int i = 0; i < N; ++i) {
        json["default"].push_back(value[i]);
    }
    return json;
}
template <std::size_t N> OrderedJson type_of(const std::array<glm::dvec3, N> &, const Range &range) {
    return array_of(array_of(number("number", range), 3, 3), N, N);
}
template <class T> OrderedJson type_of(const std::vector<T> &, const Range &range) {
    return array_of(reference(format_of<T>.name), 0, range.high);
}
template <class T> OrderedJson type_of(const std::optional<T> &, const Range &) { return reference(format_of<T>.name); }
OrderedJson type_of(const Shape &, const Range &) { return reference("mesh"); }
template <class T> OrderedJson type_of(const T &, const Range &) requires HasFormat<T> {
    return reference(format_of<T>.name);
}

template <class T> OrderedJson required_keys(const T &value) {
    OrderedJson keys = OrderedJson::array();
    for_each_field<T>([&](const auto &field) {
        if (field.rules.needed(value)) {
            keys.push_back(std::string(field.key));
        }
    });
    return keys;
}

template <class T> OrderedJson object_schema() {
    const T defaults{};
    OrderedJson json{{"type", "object"}, {"description", std::string(format_of<T>.doc)}};
    OrderedJson &properties = json["properties"];
    for_each_field<T>([&](const auto &field) {
        OrderedJson property = type_of(defaults.*field.member, field.range);
        if (field.rules.needed(defaults)) {
            property.erase("default");
        }
        // Beside $ref, draft 7 ignores other words; the referenced type describes itself.
        if (!property.contains("$ref")) {
            property["description"] = std::string(field.doc);
        }
        properties[std::string(field.key)] = std::move(property);
    });
    json["additionalProperties"] = false;
    if (OrderedJson keys = required_keys(defaults); !keys.empty()) {
        json["required"] = std::move(keys);
    }
    return json;
}

/// Which keys a light needs depends on its type; its inner cone's default depends on the outer one.
OrderedJson light_schema() {
    OrderedJson json = object_schema<Light>();
    json["properties"]["inner_cutoff_degrees"].erase("default");
    json["required"] = OrderedJson::array({"type"});
    for (const LightKind &kind : light_kinds) {
        Light light;
        light.type = kind.type;
        json["allOf"].push_back({{"if", {{"properties", {{"type", {{"const", std::string(kind.word)}}}}}}},
                                 {"then", {{"required", required_keys(light)}}}});
    }
    return json;
}

/// The two projections say in their own words how much they show.
OrderedJson camera_schema() {
    OrderedJson json = object_schema<Camera>();
    json["properties"]["height"].erase("default");
    json["if"] = {{"properties", {{"projection", {{"const", "orthographic"}}}}},
                  {"required", OrderedJson::array({"projection"})}};
    json["then"] = {{"required", OrderedJson::array({"height"})}, {"properties", {{"fov_y_degrees", false}}}};
    json["else"] = {{"properties", {{"height", false}}}};
    return json;
}

OrderedJson mesh_schema() {
    OrderedJson json;
    for_each_shape([&]<class S>(std::type_identity<S>) {
        OrderedJson shape = object_schema<S>();
        if constexpr (!std::is_same_v<S, ObjShape>) {
            shape["properties"]["shape"] = {{"const", std::string(format_of<S>.name)}};
            shape["required"] = OrderedJson::array({"shape"});
        }
        json["oneOf"].push_back(std::move(shape));
    });
    return json;
}

template <class... T> void define(OrderedJson &definitions) {
    ((definitions[std::string(format_of<T>.name)] = object_schema<T>()), ...);
}

} // namespace

std::string scene_schema() {
    OrderedJson json{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Shading Sandbox scene"}};
    json.update(object_schema<Scene>());
    json["properties"]["$schema"] = {{"type", "string"}, {"description", "For editors; ignored."}};
    OrderedJson &definitions = json["definitions"];
    define<Attenuation, Object, Transform, Material, Checker, View, Opening>(definitions);
    definitions["camera"] = camera_schema();
    definitions["light"] = light_schema();
    definitions["mesh"] = mesh_schema();
    return print_json(json);
}

} // namespace sandbox
