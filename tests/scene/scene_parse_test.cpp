#include "scene/scene_file.h"
#include "tools/error_of.h"

#include <gtest/gtest.h>

/// Text that is no JSON, or JSON that no scene would be.
namespace sandbox {
namespace {

std::string error(const std::string &text) {
    return error_of([&] { parse_scene(text, "a.json", {}); });
}

TEST(SceneText, SyntaxErrorsNameLineAndColumn) {
    EXPECT_TRUE(error("{\n  \"name\": \"x\",\n}").starts_with("a.json:3:1: syntax error"))
        << error("{\n  \"name\": \"x\",\n}");
    EXPECT_TRUE(error("").starts_with("a.json:1:1: syntax error")) << error("");
    EXPECT_TRUE(error("{} x").starts_with("a.json:1:4: syntax error")) << error("{} x");
    // A column is a character: \u00e9 is two bytes.
    EXPECT_TRUE(error("{\"\xc3\xa9\" 1}").starts_with("a.json:1:6: syntax error")) << error("{\"\xc3\xa9\" 1}");
    EXPECT_TRUE(error("{\"name\": \"a\xff\"}").starts_with("a.json:1:12: syntax error"))
        << error("{\"name\": \"a\xff\"}");
    EXPECT_TRUE(error("{'name': 1}").starts_with("a.json:1:2: ")) << error("{'name': 1}");
    EXPECT_TRUE(error("{\"name\": \"a").starts_with("a.json:1:")) << error("{\"name\": \"a");
    EXPECT_TRUE(error(std::string("{\"name\": 1\0}", 12)).starts_with("a.json:1:11: "))
        << error(std::string("{\"name\": 1\0}", 12));
}

TEST(SceneText, NumbersThatJsonDoesNotHave) {
    for (const char *number : {"NaN", "Infinity", "-Infinity", "+1", "01", ".5", "1.", "0x10", "1e"}) {
        const std::string message = error(std::string("{\"blinn_exponent_scale\": ") + number + "}");
        EXPECT_TRUE(message.starts_with("a.json:1:")) << number << ": " << message;
    }
}

TEST(SceneText, NumbersTooLargeForADouble) {
    const std::string expected = "expected a finite number: number overflow parsing '1e999'";
    EXPECT_EQ(error(R"({"blinn_exponent_scale": 1e999})"), "a.json: blinn_exponent_scale: " + expected);
    EXPECT_EQ(error(R"({"background": [0, 1e999, 0]})"), "a.json: background[1]: " + expected);
    EXPECT_EQ(error(R"({"views": [{}, {"camera": {"position": [1e999]}}]})"),
              "a.json: views[1].camera.position[0]: " + expected);
}

TEST(SceneText, KeysGivenTwice) {
    EXPECT_EQ(error(R"({"name": "a", "name": "b"})"), "a.json: name: this key is given twice");
    EXPECT_EQ(error(R"({"views": [{"name": "a"}, {"name": "b", "camera": {"far": 1, "far": 2}}]})"),
              "a.json: views[1].camera.far: this key is given twice");
    EXPECT_EQ(error(R"({"views": [{"name": "a", "camera": {}}, {"name": "b", "camera": {}}]})"), "no error");
}

TEST(SceneText, DeepNesting) {
    EXPECT_EQ(error(std::string(1000000, '[')), "a.json: nested deeper than 64 levels");
    std::string objects;
    for (int i = 0; i < 100000; ++i) {
        objects += "{\"a\":";
    }
    EXPECT_EQ(error(objects), "a.json: nested deeper than 64 levels");
}

TEST(SceneText, HugeFiles) {
    EXPECT_EQ(error(std::string((16U << 20U) + 1, ' ')), "a.json: the file is larger than 16 MiB");
    EXPECT_NE(error(std::string(16U << 20U, ' ')), "a.json: the file is larger than 16 MiB");
}

TEST(SceneText, ManyKeysAreRefusedWithoutDelay) {
    // A quadratic search through half a million keys would take minutes.
    std::string text = "{";
    for (int i = 0; i < 500000; ++i) {
        text += "\"" + std::to_string(i) + "\":0,";
    }
    EXPECT_TRUE(error(text + "\"x\":0}").starts_with("a.json: 0: unknown key of this scene; expected one of "));
    EXPECT_TRUE(error("{\"" + std::string(1000000, 'x') + "\": 0}").starts_with("a.json: xxx"));
}

} // namespace
} // namespace sandbox
