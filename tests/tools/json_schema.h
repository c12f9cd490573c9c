#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sandbox {

/// As much of JSON Schema (draft 7) as the schema uses; fails on a word it does not know.
class SchemaValidator {
  public:
    explicit SchemaValidator(const nlohmann::json &root) : root_(root) {}

    [[nodiscard]] bool accepts(const nlohmann::json &value) const { return accepts(root_, value); }

  private:
    const nlohmann::json &root_;

    [[nodiscard]] bool accepts(const nlohmann::json &schema, const nlohmann::json &value) const {
        if (schema.is_boolean()) {
            return schema.get<bool>();
        }
        return std::ranges::all_of(schema.items(),
                                   [&](const auto &item) { return obeys(schema, item.key(), item.value(), value); });
    }

    [[nodiscard]] bool obeys(const nlohmann::json &schema, const std::string &word, const nlohmann::json &rule,
                             const nlohmann::json &value) const {
        const auto accepted = [&](const nlohmann::json &part) { return accepts(part, value); };
        if (word == "$ref") {
            return accepts(root_.at(nlohmann::json::json_pointer(rule.get<std::string>().substr(1))), value);
        }
        if (word == "type") {
            return has_type(value, rule);
        }
        if (word == "enum") {
            return std::ranges::find(rule, value) != rule.end();
        }
        if (word == "const") {
            return value == rule;
        }
        if (word == "anyOf") {
            return std::ranges::any_of(rule, accepted);
        }
        if (word == "allOf") {
            return std::ranges::all_of(rule, accepted);
        }
        if (word == "oneOf") {
            return std::ranges::count_if(rule, accepted) == 1;
        }
        if (word == "if") {
            const char *const branch = accepts(rule, value) ? "then" : "else";
            return !schema.contains(branch) || accepts(schema.at(branch), value);
        }
        if (value.is_number() && (word == "minimum" || word == "maximum" || word == "exclusiveMinimum")) {
            const double number = value.get<double>();
            const double limit = rule.get<double>();
            return word == "maximum" ? number <= limit : word == "minimum" ? number >= limit : number > limit;
        }
        if (value.is_array() && (word == "minItems" || word == "maxItems")) {
            return word == "minItems" ? value.size() >= rule.get<std::size_t>()
                                      : value.size() <= rule.get<std::size_t>();
        }
        if (word == "items") {
            return !value.is_array() ||
                   std::ranges::all_of(value, [&](const nlohmann::json &e) { return accepts(rule, e); });
        }
        if (value.is_object() && word == "required") {
            return std::ranges::all_of(
                rule, [&](const nlohmann::json &key) { return value.contains(key.get<std::string>()); });
        }
        if (value.is_object() && word == "properties") {
            return std::ranges::all_of(value.items(), [&](const auto &item) {
                return !rule.contains(item.key()) || accepts(rule.at(item.key()), item.value());
            });
        }
        if (value.is_object() && word == "additionalProperties") {
            return std::ranges::all_of(value.items(),
                                       [&](const auto &item) { return schema.at("properties").contains(item.key()); });
        }
        static const std::vector<std::string> elsewhere{
            "$schema",  "title",    "description", "default",    "definitions",
            "then",     "else",     "minimum",     "maximum",    "exclusiveMinimum",
            "minItems", "maxItems", "required",    "properties", "additionalProperties"};
        EXPECT_NE(std::ranges::find(elsewhere, word), elsewhere.end()) << word;
        return true;
    }

    static bool has_type(const nlohmann::json &value, const std::string &type) {
        return type == "object"    ? value.is_object()
               : type == "array"   ? value.is_array()
               : type == "string"  ? value.is_string()
               : type == "boolean" ? value.is_boolean()
               : type == "integer" ? value.is_number_integer()
                                   : value.is_number();
    }
};

} // namespace sandbox
