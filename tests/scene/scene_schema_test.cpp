#include "image/image_file.h"
#include "scene/scene_file.h"
#include "scene/scene_schema.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using Json = nlohmann::json;

const std::filesystem::path schema_file = std::filesystem::path(SOURCE_DIR) / "assets/scene.schema.json";

TEST(SceneSchema, IsUpToDate) {
    if (std::getenv("SANDBOX_UPDATE_SCHEMA") != nullptr) {
        write_file(schema_file, scene_schema());
    }
    EXPECT_EQ(read_file(schema_file), scene_schema())
        << "the scene format has changed; run the tests once with SANDBOX_UPDATE_SCHEMA=1 to write "
        << "assets/scene.schema.json anew, and say so in the CHANGELOG";
}

/// As much of JSON Schema (draft 7) as the schema uses; fails on a word it does not know.
class Validator {
  public:
    explicit Validator(const Json &root) : root_(root) {}

    [[nodiscard]] bool accepts(const Json &value) const { return accepts(root_, value); }

  private:
    const Json &root_;

    [[nodiscard]] bool accepts(const Json &schema, const Json &value) const {
        if (schema.is_boolean()) {
            return schema.get<bool>();
        }
        return std::ranges::all_of(schema.items(),
                                   [&](const auto &item) { return obeys(schema, item.key(), item.value(), value); });
    }

    [[nodiscard]] bool obeys(const Json &schema, const std::string &word, const Json &rule, const Json &value) const {
        const auto accepted = [&](const Json &part) { return accepts(part, value); };
        if (word == "$ref") {
            return accepts(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value);
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
            return !value.is_array() || std::ranges::all_of(value, [&](const Json &e) { return accepts(rule, e); });
        }
        if (value.is_object() && word == "required") {
            return std::ranges::all_of(rule, [&](const Json &key) { return value.contains(key.get<std::string>()); });
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

    static bool has_type(const Json &value, const std::string &type) {
        return type == "object"    ? value.is_object()
               : type == "array"   ? value.is_array()
               : type == "string"  ? value.is_string()
               : type == "boolean" ? value.is_boolean()
               : type == "integer" ? value.is_number_integer()
                                   : value.is_number();
    }
};

TEST(SceneSchema, AcceptsTheBuiltInScenes) {
    const Json schema = Json::parse(scene_schema());
    const Assets assets("assets");
    for (const std::string &name : builtin_scenes(assets)) {
        EXPECT_TRUE(Validator(schema).accepts(Json::parse(*assets.read("scenes/" + name + ".json")))) << name;
        EXPECT_TRUE(Validator(schema).accepts(Json::parse(scene_text(open_scene(name, assets))))) << name;
    }
}

TEST(SceneSchema, RefusesWhatTheReaderRefuses) {
    const Json schema = Json::parse(scene_schema());
    for (const char *text :
         {R"([])",
          R"({"x": 1})",
          R"({"name": 1})",
          R"({"background": [0, 0]})",
          R"({"background": [0, 0, -1]})",
          R"({"blinn_exponent_scale": 0})",
          R"({"lights": [{}]})",
          R"({"lights": [{"type": "point"}]})",
          R"({"lights": [{"type": "directional"}]})",
          R"({"lights": [{"type": "lamp"}]})",
          R"({"lights": [{"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 1], "cutoff_degrees": 91}]})",
          R"({"objects": [{}]})",
          R"({"objects": [{"mesh": {}}]})",
          R"({"objects": [{"mesh": {"shape": "ball"}}]})",
          R"({"objects": [{"mesh": {"shape": "box", "radius": 1}}]})",
          R"({"objects": [{"mesh": {"shape": "sphere", "rings": 1}}]})",
          R"({"objects": [{"mesh": {"shape": "sphere", "rings": 2.5}}]})",
          R"({"objects": [{"mesh": {"shape": "box"}, "two_sided": 1}]})",
          R"({"views": [{"name": "a"}]})",
          R"({"camera": {"projection": "isometric"}})",
          R"({"camera": {"projection": "orthographic"}})",
          R"({"camera": {"projection": "orthographic", "height": 0}})",
          R"({"camera": {"height": 2}})",
          R"({"camera": {"projection": "orthographic", "height": 2, "fov_y_degrees": 45}})",
          R"({"compare": "wipe"})",
          R"({"compare": {"left": 1}})",
          R"({"compare": {"middle": "flat/lambert"}})",
          R"({"objects": [{"mesh": {"shape": "box"}, "material": {"texture_repeat": [1, 0]}}]})",
          R"({"objects": [{"mesh": {"shape": "box"}, "material": {"texture_color_space": "sRGB"}}]})"}) {
        EXPECT_THROW(parse_scene(text, "a.json", {}), std::runtime_error) << text;
        EXPECT_FALSE(Validator(schema).accepts(Json::parse(text))) << text;
    }
    EXPECT_TRUE(Validator(schema).accepts(Json::parse(
        R"({"$schema": "x", "lights": [{"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 1], "cutoff_degrees": 180}]})")));
}

} // namespace
} // namespace sandbox
