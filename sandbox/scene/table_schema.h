#pragma once

#include "scene/scene_format.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// JSON schemas (draft 7) made from tables such as those of scene_format.h.
namespace sandbox {

/// What a Derived schema shares with others. `Json` is nlohmann's ordered one, which headers do not name. Derived adds
/// `type_of` for the types of its own, beside these (`using`).
template <class Derived, class Json> class TableSchema {
  public:
    template <class T> [[nodiscard]] Json object() const {
        const T defaults{};
        Json json{{"type", "object"}, {"description", std::string(format_of<T>.doc)}};
        Json &properties = json["properties"];
        for_each_field<T>([&](const auto &field) {
            Json property = self().type_of(defaults.*field.member, field.range);
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
        if (Json keys = required_keys(defaults); !keys.empty()) {
            json["required"] = std::move(keys);
        }
        return json;
    }
    template <class T> static Json required_keys(const T &value) {
        Json keys = Json::array();
        for_each_field<T>([&](const auto &field) {
            if (field.rules.needed(value)) {
                keys.push_back(std::string(field.key));
            }
        });
        return keys;
    }
    template <class... T> void define(Json &definitions) const {
        ((definitions[std::string(format_of<T>.name)] = object<T>()), ...);
    }
    /// The beginning of a whole schema: that of T, under a title; its keys may be joined by "$schema".
    template <class T> [[nodiscard]] Json document(std::string_view title) const {
        Json json{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", std::string(title)}};
        json.update(object<T>());
        json["properties"]["$schema"] = {{"type", "string"}, {"description", "For editors; ignored."}};
        return json;
    }

  protected:
    static Json reference(std::string_view name) { return {{"$ref", "#/definitions/" + std::string(name)}}; }
    static Json number(std::string_view type, const Range &range) {
        Json json{{"type", std::string(type)}};
        if (std::isfinite(range.low)) {
            json[range.above_low ? "exclusiveMinimum" : "minimum"] = range.low;
        }
        if (std::isfinite(range.high)) {
            json["maximum"] = range.high;
        }
        if (!std::isnan(range.or_exactly)) {
            return {{"anyOf", Json::array({json, {{"const", range.or_exactly}}})}};
        }
        return json;
    }
    static Json array_of(Json items, std::size_t low, double high) {
        Json json{{"type", "array"}, {"items", std::move(items)}};
        if (low > 0) {
            json["minItems"] = low;
        }
        if (std::isfinite(high)) {
            json["maxItems"] = high;
        }
        return json;
    }
    static Json words(const auto &all) {
        Json list = Json::array();
        for (const std::string_view word : all) {
            list.push_back(std::string(word));
        }
        return {{"enum", std::move(list)}};
    }

    /// The type of a key and, where it is plain, its default.
    template <class Number> Json type_of(Number value, const Range &range) const requires std::is_arithmetic_v<Number> {
        Json json = number(std::is_integral_v<Number> ? "integer" : "number", range);
        json["default"] = value;
        return json;
    }
    Json type_of(bool value, const Range &) const { return {{"type", "boolean"}, {"default", value}}; }
    Json type_of(const std::string &, const Range &) const { return {{"type", "string"}}; }
    template <class E> Json type_of(const E &value, const Range &) const requires HasWords<E> {
        Json json = words(words_of<E>);
        json["default"] = std::string(words_of<E>[static_cast<std::size_t>(value)]);
        return json;
    }
    template <int N> Json type_of(const glm::vec<N, double> &value, const Range &range) const {
        Json json = array_of(number("number", range), N, N);
        for (int i = 0; i < N; ++i) {
            json["default"].push_back(value[i]);
        }
        return json;
    }
    template <std::size_t N> Json type_of(const std::array<glm::dvec3, N> &, const Range &range) const {
        return array_of(array_of(number("number", range), 3, 3), N, N);
    }
    template <class T> Json type_of(const std::vector<T> &, const Range &range) const {
        return array_of(without_default(T{}, any), 0, range.high);
    }
    template <class T> Json type_of(const std::optional<T> &, const Range &range) const {
        return without_default(T{}, range);
    }
    template <class T> Json type_of(const T &, const Range &) const requires HasFormat<T> {
        return reference(format_of<T>.name);
    }

  private:
    [[nodiscard]] const Derived &self() const { return static_cast<const Derived &>(*this); }
    template <class T> Json without_default(const T &value, const Range &range) const {
        Json json = self().type_of(value, range);
        json.erase("default");
        return json;
    }
};

} // namespace sandbox
