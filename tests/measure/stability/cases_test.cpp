#include "measure/stability/cases.h"

#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

const std::string story = R"("group": "spot", "symptom": "dark", "cause": "cos", "source": "a lamp")";

StabilityCase parse(const std::string &keys) {
    return parse_stability_case("{" + story + ", " + keys + "}", "cases/spot-mine.json", {}, Assets("assets"));
}

std::string error(const std::string &text) {
    return error_of([&] { parse_stability_case(text, "mine.json", {}, Assets("assets")); });
}
std::string error_in(const std::string &keys) { return error("{" + story + ", " + keys + "}"); }

TEST(StabilityCases, NeedLittleMoreThanASceneAndAStory) {
    const StabilityCase read = parse(R"("scene": "ball")");
    EXPECT_EQ(read.name, "spot-mine");
    EXPECT_EQ(read.group, "spot");
    EXPECT_EQ(read.cause, "cos");
    EXPECT_EQ(read.scene.lights.size(), 2U);
    EXPECT_EQ(read.techniques.size(), 4U);
    EXPECT_FALSE(read.textbook);
    EXPECT_EQ(read.textbook_target, TextbookTarget::float32);
    EXPECT_EQ(read.seen_on, "");
    EXPECT_EQ(read.bound, 1.0 / 255);
    EXPECT_EQ(read.unit, ErrorUnit::linear_color);
}

TEST(StabilityCases, SayAllThatCanBeSaid) {
    const StabilityCase read = parse(R"("scene": {"lights": [{"type": "point", "position": [1, 2, 3]}],
        "objects": [{"mesh": {"shape": "box"}}]}, "set": ["camera.far=7", "lights[0].diffuse=0.5"],
        "techniques": ["flat/phong"], "textbook": "per-pixel/phong:power=textbook", "bound": 1e-5,
        "unit": "brightest value", "textbook_target": "half", "seen_on": "a phone")");
    EXPECT_EQ(read.scene.camera.far_plane, 7);
    EXPECT_EQ(read.scene.lights[0].diffuse, 0.5);
    EXPECT_EQ(read.techniques, std::vector{parse_technique("flat/phong")});
    EXPECT_EQ(read.textbook, parse_technique("per-pixel/phong:power=textbook"));
    EXPECT_EQ(read.textbook_target, TextbookTarget::half);
    EXPECT_EQ(read.seen_on, "a phone");
    EXPECT_EQ(read.bound, 1e-5);
    EXPECT_EQ(read.unit, ErrorUnit::brightest_value);
}

TEST(StabilityCases, FindScenesAndMeshesBesideTheirFile) {
    const TemporaryFolder folder;
    folder.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("mine.json", R"({"objects": [{"mesh": {"obj": "one.obj"}}]})");
    folder.write("case.json", "{" + story + R"(, "scene": "mine.json", "set": ["objects[0].mesh.obj=one.obj"]})");
    const StabilityCase read = open_stability_case((folder.path() / "case.json").string(), Assets("assets"));
    EXPECT_EQ(read.name, "case");
    EXPECT_EQ(read.scene.objects[0].mesh, Shape(ObjShape{(folder.path() / "one.obj").string()}));
    EXPECT_FALSE(parse(R"("scene": "point-light")").scene.description.empty()) << "a built-in scene";
}

TEST(StabilityCases, ErrorsNameFileKeyAndWhatWasExpected) {
    EXPECT_TRUE(error("{").starts_with("mine.json:1:2: syntax error")) << error("{");
    EXPECT_EQ(error("[]"), "mine.json: expected an object, got []");
    EXPECT_EQ(error(R"({"group": "spot"})"), "mine.json: symptom: missing; expected a string that is not empty");
    EXPECT_EQ(error(R"({"group": 3})"), "mine.json: group: expected a string that is not empty, got 3");
    EXPECT_EQ(error_in(R"("bonud": 1)"), "mine.json: bonud: unknown key of a stability case; did you mean \"bound\"?");
    EXPECT_EQ(error_in(R"("bound": 1)"),
              "mine.json: scene: missing; expected a scene's name, a file or a scene object");
    EXPECT_EQ(error_in(R"("scene": "ball", "bound": 0)"), "mine.json: bound: expected a number > 0, got 0");
    EXPECT_EQ(error_in(R"("scene": "ball", "unit": "light")"),
              "mine.json: unit: expected \"linear colour\" or \"brightest value\", got \"light\"");
    EXPECT_EQ(error_in(R"("scene": "ball", "textbook_target": "quarter")"),
              "mine.json: textbook_target: expected \"float32\" or \"half\", got \"quarter\"");
    EXPECT_EQ(error_in(R"("scene": "ball", "seen_on": "")"),
              "mine.json: seen_on: expected a string that is not empty, got \"\"");
    EXPECT_EQ(error_in(R"("scene": "ball", "set": "camera.far=1")"),
              "mine.json: set: expected a list of strings PATH=VALUE, got \"camera.far=1\"");
    EXPECT_EQ(error_in(R"("scene": "ball", "set": ["lights[7].diffuse=1"])"),
              "mine.json: set lights[7].diffuse: index 7 is out of range; there are 2");
    EXPECT_EQ(error_in(R"("scene": "ball", "set": ["lights[0].diffuse=-1"])"),
              "mine.json: set: lights[0].diffuse: expected a number >= 0, got -1");
    EXPECT_EQ(error_in(R"("scene": "ball", "techniques": [])"),
              "mine.json: techniques: expected a list of techniques, got []");
    EXPECT_TRUE(error_in(R"("scene": "ball", "techniques": ["flat/fong"])").starts_with("mine.json: techniques: "));
    EXPECT_TRUE(error_in(R"("scene": "bal")").starts_with("mine.json: scene: bal: no built-in scene"));
    EXPECT_TRUE(error_in(R"("scene": {"lights": 3})").starts_with("mine.json: scene: lights: expected an array"));
}

TEST(StabilityCases, AreFoundByNameOrByFile) {
    EXPECT_EQ(open_stability_case("spot-cutoff-0", Assets("assets")).scene.lights[0].cutoff_degrees, 0);
    EXPECT_EQ(error_of([] { open_stability_case("spot-cutof-0", Assets("assets")); }),
              "there is no case 'spot-cutof-0'; did you mean 'spot-cutoff-0'?");
    EXPECT_NE(error_of([] { open_stability_case("none.json", Assets("assets")); }).find("none.json"),
              std::string::npos);
}

TEST(StabilityCases, StandInTheOrderOfTheList) {
    const auto order = nlohmann::json::parse(Assets("assets").read("stability/order.json").value_or(""));
    const std::vector<StabilityCase> cases = stability_cases();
    std::size_t next = 0;
    for (const StabilityCase &read : cases) {
        next += next < order.size() && order[next] == read.name ? 1 : 0;
    }
    EXPECT_EQ(next, order.size()) << "no case, or not in its place: " << order[std::min(next, order.size() - 1)];
    EXPECT_EQ(cases.front().name, "exponent-0-phong");
}

TEST(StabilityCases, OneThatNobodyOrderedComesLastInItsGroup) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "stability" / "cases");
    for (const std::string name : {"a", "b", "c"}) {
        folder.write("stability/cases/" + name + ".json",
                     R"({"symptom": "s", "cause": "c", "source": "s", "scene": {"objects": []}, "group": ")" +
                         std::string(name == "b" ? "two" : "one") + "\"}");
    }
    folder.write("stability/order.json", R"(["c", "b"])");
    std::string names;
    for (const StabilityCase &read : stability_cases(Assets("assets", folder.path()))) {
        names += read.name;
    }
    EXPECT_EQ(names, "cab");
}

} // namespace
} // namespace sandbox
