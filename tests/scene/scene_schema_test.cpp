#include "image/image_file.h"
#include "scene/scene_file.h"
#include "scene/scene_schema.h"
#include "tools/json_schema.h"

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

TEST(SceneSchema, AcceptsTheBuiltInScenes) {
    const Json schema = Json::parse(scene_schema());
    const Assets assets("assets");
    for (const std::string &name : builtin_scenes(assets)) {
        EXPECT_TRUE(SchemaValidator(schema).accepts(Json::parse(*assets.read("scenes/" + name + ".json")))) << name;
        EXPECT_TRUE(SchemaValidator(schema).accepts(Json::parse(scene_text(open_scene(name, assets))))) << name;
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
        EXPECT_FALSE(SchemaValidator(schema).accepts(Json::parse(text))) << text;
    }
    EXPECT_TRUE(SchemaValidator(schema).accepts(Json::parse(
        R"({"$schema": "x", "lights": [{"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 1], "cutoff_degrees": 180}]})")));
}

} // namespace
} // namespace sandbox
