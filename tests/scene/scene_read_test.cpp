#include "scene/scene_file.h"
#include "scene/scene_format.h"
#include "tools/error_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {
namespace {

Scene parse(const std::string &text) { return parse_scene(text, "a.json", "/nowhere"); }
std::string error(const std::string &text) {
    return error_of([&] { parse(text); });
}
/// The message for one light; each begins with "a.json: lights[0].".
std::string light_error(const std::string &keys) {
    const std::string message =
        error(R"({"lights": [{"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 1], )" + keys + "}]}");
    const std::string before = "a.json: lights[0].";
    return message.starts_with(before) ? message.substr(before.size()) : message;
}
std::string object_error(const std::string &mesh, const std::string &rest = "") {
    const std::string message = error(R"({"objects": [{"mesh": )" + mesh + rest + "}]}");
    const std::string before = "a.json: objects[0].";
    return message.starts_with(before) ? message.substr(before.size()) : message;
}
std::string material_error(const std::string &keys) {
    return object_error(R"({"shape": "box"})", R"(, "material": {)" + keys + "}");
}

TEST(SceneDefaults, AreThoseOfTheFormat) {
    const Scene scene = parse(R"({"lights": [{"type": "spot", "position": [0, 3, 0], "direction": [0, -1, 0]}],
                                  "objects": [{"mesh": {"shape": "sphere"}}]})");
    EXPECT_EQ(scene.background, glm::dvec3(0));
    EXPECT_EQ(scene.ambient, glm::dvec3(0));
    EXPECT_EQ(scene.blinn_exponent_scale, 1);
    EXPECT_EQ(scene.camera.position, glm::dvec3(0, 1, 6));
    EXPECT_EQ(scene.camera.target, glm::dvec3(0));
    EXPECT_EQ(scene.camera.up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(scene.camera.fov_y_degrees, 45);
    EXPECT_EQ(scene.camera.near_plane, 0.1);
    EXPECT_EQ(scene.camera.far_plane, 100);
    const Light &light = scene.lights.at(0);
    EXPECT_TRUE(light.enabled);
    EXPECT_EQ(light.color, glm::dvec3(1));
    EXPECT_EQ(light.ambient, 0);
    EXPECT_EQ(light.diffuse, 1);
    EXPECT_EQ(light.specular, 1);
    EXPECT_FALSE(light.attenuate_ambient);
    EXPECT_EQ(light.attenuation, (Attenuation{1, 0, 0}));
    EXPECT_EQ(light.cutoff_degrees, 30);
    EXPECT_EQ(light.inner_cutoff_degrees, 30);
    EXPECT_EQ(light.exponent, 0);
    const Object &object = scene.objects.at(0);
    EXPECT_EQ(object.mesh, Shape(SphereShape{1, 32, 64}));
    EXPECT_EQ(object.transform, Transform{});
    EXPECT_FALSE(object.two_sided);
    const Material &material = object.material;
    EXPECT_EQ(material.ambient, glm::dvec3(1));
    EXPECT_EQ(material.diffuse, glm::dvec3(1));
    EXPECT_EQ(material.specular, glm::dvec3(1));
    EXPECT_EQ(material.emission, glm::dvec3(0));
    EXPECT_EQ(material.shininess, 32);
    EXPECT_TRUE(material.texture.empty());
    EXPECT_TRUE(material.texture_modulates_specular);
    EXPECT_FALSE(material.checker);
}

TEST(SceneDefaults, OfShapes) {
    const auto shape = [](const std::string &name) {
        return parse(R"({"objects": [{"mesh": {"shape": ")" + name + R"("}}]})").objects.at(0).mesh;
    };
    EXPECT_EQ(shape("box"), Shape(BoxShape{{1, 1, 1}, 1}));
    EXPECT_EQ(shape("plane"), Shape(PlaneShape{{2, 2}, 1}));
    EXPECT_EQ(shape("cylinder"), Shape(CylinderShape{0.5, 1, 64, 1, true}));
    EXPECT_EQ(shape("torus"), Shape(TorusShape{1, 0.4, 64, 32}));
}

TEST(SceneDefaults, TheInnerConeFollowsTheOuter) {
    const auto light = [](const std::string &keys) {
        return parse(R"({"lights": [{"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 1], )" + keys + "}]}")
            .lights.at(0);
    };
    EXPECT_EQ(light(R"("cutoff_degrees": 12)").inner_cutoff_degrees, 12);
    EXPECT_EQ(light(R"("cutoff_degrees": 180)").inner_cutoff_degrees, 180);
    EXPECT_EQ(light(R"("cutoff_degrees": 40, "inner_cutoff_degrees": 0)").inner_cutoff_degrees, 0);
}

TEST(SceneRead, TakesWhatTheFormatNeedNotBeToldTwice) {
    EXPECT_EQ(parse("{}"), Scene{});
    EXPECT_EQ(parse("\xef\xbb\xbf{}"), Scene{}); // a byte order mark
    EXPECT_EQ(parse(R"({"$schema": "../scene.schema.json"})"), Scene{});
    EXPECT_EQ(parse(R"({"lights": [{"type": "point", "position": [0, 0, 0], "enabled": false}]})").lights[0].enabled,
              false);
    EXPECT_EQ(parse(R"({"scene": {"name": "inside"}, "techniques": ["per-pixel/phong"], "size": [1, 2]})").name,
              "inside"); // a sidecar
}

TEST(SceneErrors, NumbersOutOfRange) {
    EXPECT_EQ(light_error(R"("attenuation": {"linear": -1})"), "attenuation.linear: expected a number >= 0, got -1");
    EXPECT_EQ(light_error(R"("attenuation": {"quadratic": 2e9})"),
              "attenuation.quadratic: expected a number from 0 to 1e9, got 2000000000.0");
    EXPECT_EQ(light_error(R"("diffuse": 1000001)"), "diffuse: expected a number from 0 to 1e6, got 1000001");
    EXPECT_EQ(light_error(R"("ambient": -0.5)"), "ambient: expected a number >= 0, got -0.5");
    EXPECT_EQ(light_error(R"("specular": -1e-300)"), "specular: expected a number >= 0, got -1e-300");
    EXPECT_EQ(light_error(R"("color": [0, -1, 0])"), "color[1]: expected a number >= 0, got -1");
    EXPECT_EQ(light_error(R"("exponent": 100001)"), "exponent: expected a number from 0 to 1e5, got 100001");
    EXPECT_EQ(light_error(R"("cutoff_degrees": 91)"), "cutoff_degrees: expected a number from 0 to 90, or 180, got 91");
    EXPECT_EQ(light_error(R"("cutoff_degrees": -1)"), "cutoff_degrees: expected a number from 0 to 90, or 180, got -1");
    EXPECT_EQ(error(R"({"lights": [{"type": "point", "position": [0, 1.5e9, 0]}]})"),
              "a.json: lights[0].position[1]: expected a number from -1e9 to 1e9, got 1500000000.0");
    EXPECT_EQ(error(R"({"blinn_exponent_scale": 0})"), "a.json: blinn_exponent_scale: expected a number > 0, got 0");
    EXPECT_EQ(error(R"({"blinn_exponent_scale": 16.5})"),
              "a.json: blinn_exponent_scale: expected a number above 0, at most 16, got 16.5");
    EXPECT_EQ(error(R"({"camera": {"fov_y_degrees": 180}})"),
              "a.json: camera.fov_y_degrees: expected a number above 0, at most 179, got 180");
    EXPECT_EQ(error(R"({"camera": {"position": [0, 2e10, 1]}})"),
              "a.json: camera.position[1]: expected a number from -1e10 to 1e10, got 20000000000.0");
    EXPECT_EQ(error(R"({"camera": {"projection": "orthographic"}})"),
              "a.json: camera.height: missing; expected a number");
    EXPECT_EQ(error(R"({"camera": {"projection": "orthographic", "height": 0}})"),
              "a.json: camera.height: expected a number > 0, got 0");
    EXPECT_EQ(error(R"({"camera": {"projection": "orthographic", "height": 2, "fov_y_degrees": 45}})"),
              "a.json: camera.fov_y_degrees: expected height in its place beside projection orthographic");
    EXPECT_EQ(error(R"({"camera": {"near": 0}})"), "a.json: camera.near: expected a number > 0, got 0");
    EXPECT_EQ(error(R"({"background": [0, 0, -1]})"), "a.json: background[2]: expected a number >= 0, got -1");
    EXPECT_EQ(material_error(R"("shininess": 10000001)"),
              "material.shininess: expected a number from 0 to 1e7, got 10000001");
    EXPECT_EQ(material_error(R"("emission": [2e6, 0, 0])"),
              "material.emission[0]: expected a number from 0 to 1e6, got 2000000.0");
    EXPECT_EQ(object_error(R"({"shape": "sphere", "radius": 0})"), "mesh.radius: expected a number > 0, got 0");
    EXPECT_EQ(object_error(R"({"shape": "sphere", "rings": 1})"),
              "mesh.rings: expected a whole number from 2 to 2048, got 1");
    EXPECT_EQ(object_error(R"({"shape": "box", "divisions": 513})"),
              "mesh.divisions: expected a whole number from 1 to 512, got 513");
    EXPECT_EQ(object_error(R"({"shape": "box"})", R"(, "transform": {"scale": [1, 2e15, 1]})"),
              "transform.scale[1]: expected a number from -1e15 to 1e15, got 2e+15");
}

TEST(SceneRead, UpAlongTheViewIsRefused) {
    EXPECT_EQ(error(R"({"camera": {"position": [0, 5, 0]}})"),
              "a.json: camera.up: expected a direction other than the view's, from position to target, got the usual "
              "[0, 1, 0]");
    EXPECT_EQ(error(R"({"camera": {"position": [0, 0, 5], "up": [0, 0, -2]}})"),
              "a.json: camera.up: expected a direction other than the view's, from position to target, got [0, 0, -2]");
    EXPECT_EQ(error(R"({"views": [{"name": "a", "camera": {"position": [0, 5, 0]}}]})").substr(0, 27),
              "a.json: views[0].camera.up:");
    // 1e-9 of the length, whatever that is.
    EXPECT_NE(error(R"({"camera": {"position": [0, 5e9, 0], "up": [0, 1, 0.9e-9]}})"), "no error");
    EXPECT_EQ(error(R"({"camera": {"position": [0, 5e9, 0], "up": [0, 1, 1.1e-9]}})"), "no error");
}

TEST(SceneErrors, TheEdgesOfRangesAreIn) {
    for (const char *keys :
         {R"("cutoff_degrees": 0)", R"("cutoff_degrees": 90)", R"("cutoff_degrees": 180)", R"("exponent": 1e5)",
          R"("diffuse": 1e6)", R"("attenuation": {"constant": 0, "quadratic": 1e9})",
          R"("cutoff_degrees": 20, "inner_cutoff_degrees": 20)"}) {
        EXPECT_EQ(light_error(keys), "no error") << keys;
    }
    EXPECT_EQ(material_error(R"("shininess": 0)"), "no error");
    EXPECT_EQ(material_error(R"("shininess": 1e7)"), "no error");
    EXPECT_EQ(object_error(R"({"shape": "box"})", R"(, "transform": {"scale": [0, -1e15, 1]})"), "no error");
    EXPECT_EQ(error(R"({"blinn_exponent_scale": 16, "camera": {"fov_y_degrees": 179}})"), "no error");
}

TEST(SceneErrors, WrongTypes) {
    EXPECT_EQ(light_error(R"("diffuse": "red")"), "diffuse: expected a number, got \"red\"");
    EXPECT_EQ(light_error(R"("diffuse": true)"), "diffuse: expected a number, got true");
    EXPECT_EQ(light_error(R"("diffuse": null)"), "diffuse: expected a number, got null");
    EXPECT_EQ(light_error(R"("enabled": 1)"), "enabled: expected true or false, got 1");
    EXPECT_EQ(light_error(R"("color": 1)"), "color: expected an array of 3 numbers, got 1");
    EXPECT_EQ(light_error(R"("color": [1, 1])"), "color: expected an array of 3 numbers, got [1,1]");
    EXPECT_EQ(light_error(R"("color": [1, 1, "x"])"), "color[2]: expected a number, got \"x\"");
    EXPECT_EQ(light_error(R"("attenuation": [1, 0, 0])"), "attenuation: expected an object, got [1,0,0]");
    EXPECT_EQ(error(R"({"name": 3})"), "a.json: name: expected a string, got 3");
    EXPECT_EQ(error(R"({"lights": {}})"), "a.json: lights: expected an array, got {}");
    EXPECT_EQ(error(R"({"lights": [3]})"), "a.json: lights[0]: expected an object, got 3");
    EXPECT_EQ(error(R"([])"), "a.json: expected an object, got []");
    EXPECT_EQ(object_error(R"({"shape": "sphere", "rings": 2.5})"), "mesh.rings: expected a whole number, got 2.5");
    EXPECT_EQ(object_error(R"({"shape": 3})"), "mesh.shape: expected a string, got 3");
    EXPECT_EQ(object_error(R"("box")"), "mesh: expected an object with \"shape\" or \"obj\", got \"box\"");
    EXPECT_EQ(material_error(R"("checker": {"colors": [[1, 1, 1]]})"),
              "material.checker.colors: expected an array of 2 colours, got [[1,1,1]]");
    EXPECT_EQ(
        error(R"({"name": [)" + std::string(200, ' ') + R"("a long text that goes on and on and on and on and on"]})"),
        "a.json: name: expected a string, got [\"a long text that goes on and on and on and on and on\"]");
}

/// "ambient, diffuse, ..."
std::string keys_of_a_material() {
    std::vector<std::string_view> keys;
    for_each_field<Material>([&](const auto &field) { keys.push_back(field.key); });
    return fmt::format("{}", fmt::join(keys, ", "));
}

/// In quotation marks.
std::string kinds_of_light() {
    std::vector<std::string> words;
    for (const LightKind &kind : light_kinds) {
        words.push_back(fmt::format("\"{}\"", kind.word));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

TEST(SceneErrors, UnknownKeysWithTheNearestKnown) {
    EXPECT_EQ(light_error(R"("difuse": 1)"), "difuse: unknown key of this light; did you mean \"diffuse\"?");
    EXPECT_EQ(light_error(R"("colour": [1, 1, 1])"), "colour: unknown key of this light; did you mean \"color\"?");
    EXPECT_EQ(light_error(R"("attenuation": {"weight": 1})"),
              "attenuation.weight: unknown key of this attenuation; expected one of constant, linear, quadratic");
    EXPECT_EQ(error(R"({"ligths": []})"), "a.json: ligths: unknown key of this scene; did you mean \"lights\"?");
    EXPECT_EQ(material_error(R"("shine": 3)"),
              "material.shine: unknown key of this material; expected one of " + keys_of_a_material());
    EXPECT_EQ(object_error(R"({"shape": "box", "radius": 1})"),
              "mesh.radius: unknown key of this box; expected one of shape, size, divisions");
    EXPECT_EQ(object_error(R"({"shape": "ball"})"), "mesh.shape: unknown shape, got \"ball\"; expected one of sphere, "
                                                    "box, plane, cylinder, torus");
    EXPECT_EQ(object_error(R"({"shape": "tours"})"),
              "mesh.shape: unknown shape, got \"tours\"; did you mean \"torus\"?");
    EXPECT_EQ(object_error(R"({"shpae": "box"})"), "mesh.shpae: unknown key of this mesh; did you mean \"shape\"?");
    EXPECT_EQ(object_error(R"({"obj": "a.obj", "radius": 1})"),
              "mesh.radius: unknown key of this obj; expected one of obj, usemtl");
    EXPECT_EQ(light_error(R"("type2": 1)"), "type2: unknown key of this light; did you mean \"type\"?");
}

TEST(SceneErrors, MissingKeys) {
    EXPECT_EQ(error(R"({"lights": [{}]})"), "a.json: lights[0].type: missing; expected one of " + kinds_of_light());
    EXPECT_EQ(error(R"({"lights": [{"type": "point"}]})"),
              "a.json: lights[0].position: missing; expected an array of 3 numbers");
    EXPECT_EQ(error(R"({"lights": [{"type": "directional"}]})"),
              "a.json: lights[0].direction: missing; expected an array of 3 numbers");
    EXPECT_EQ(error(R"({"lights": [{"type": "spot", "position": [0, 0, 0]}]})"),
              "a.json: lights[0].direction: missing; expected an array of 3 numbers");
    EXPECT_EQ(error(R"({"objects": [{}]})"),
              R"(a.json: objects[0].mesh: missing; expected an object with "shape" or "obj")");
    EXPECT_EQ(error(R"({"views": [{"camera": {}}]})"), "a.json: views[0].name: missing; expected a string");
    EXPECT_EQ(error(R"({"views": [{"name": "a"}]})"), "a.json: views[0].camera: missing; expected an object");
    EXPECT_EQ(object_error("{}"), R"(mesh: expected "shape" or "obj", got {})");
}

TEST(SceneErrors, KeysThatDisagree) {
    EXPECT_EQ(light_error(R"("inner_cutoff_degrees": 31)"),
              "inner_cutoff_degrees: expected at most cutoff_degrees (30), got 31");
    EXPECT_EQ(light_error(R"("attenuation": {"constant": 0})"),
              "attenuation: expected a coefficient above 0, got {\"constant\":0}");
    EXPECT_EQ(light_error(R"("type": "spot")"), "type: this key is given twice");
    EXPECT_EQ(error(R"({"camera": {"near": 5, "far": 5}})"),
              "a.json: camera.far: expected near < far, got near 5, far 5");
    EXPECT_EQ(error(R"({"camera": {"near": 200}})"), "a.json: camera.near: expected near < far, got near 200, far 100");
    EXPECT_EQ(error(R"({"camera": {"target": [0, 1, 6]}})"),
              "a.json: camera.target: expected a point other than the camera's position");
    EXPECT_EQ(error(R"({"camera": {"up": [0, 0, 0]}})"),
              "a.json: camera.up: expected a vector other than (0, 0, 0), got [0,0,0]");
    EXPECT_EQ(material_error(R"("texture": "a.png", "checker": {})"),
              "material.checker: expected checker or texture, got both");
    EXPECT_EQ(object_error(R"({"obj": ""})"), "mesh.obj: expected a path, got \"\"");
    EXPECT_EQ(error(R"({"views": [{"name": "a", "camera": {}}, {"name": "a", "camera": {}}]})"),
              "a.json: views[1].name: expected a name of its own, got \"a\" again");
}

TEST(SceneErrors, AtMost64Lights) {
    const auto lights = [](int count) {
        std::string text = R"({"lights": [)";
        for (int i = 0; i < count; ++i) {
            text += std::string(i > 0 ? "," : "") + R"({"type": "point", "position": [0, 0, 0]})";
        }
        return text + "]}";
    };
    EXPECT_EQ(error(lights(64)), "no error");
    EXPECT_EQ(error(lights(65)), "a.json: lights: expected at most 64 elements, got 65");
}

} // namespace
} // namespace sandbox
