#include "measure/report/stability_report.h"
#include "reference/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace sandbox {
namespace {

constexpr Size small{33, 33};

/// A ball in the ambient light of `ambient`: every pixel of it has that value.
StabilityCase plain_case(double ambient, double bound) {
    StabilityCase one;
    one.name = "plain";
    one.group = "test";
    one.scene.ambient = glm::dvec3(ambient);
    one.scene.objects = {{"ball", SphereShape{}, {}, {}, false}};
    one.techniques = {parse_technique("per-pixel/lambert")};
    one.bound = bound;
    return one;
}

/// Draws the reference's picture, wrong by `error` everywhere.
StabilityDraw fake(double error) {
    const auto load = [](const Scene &scene) {
        return std::vector<ObjectResources>{{std::make_shared<const Mesh>(build_mesh(scene.objects[0].mesh)), {}}};
    };
    return {load,
            [=](const Scene &scene, const Technique &technique, Size size) {
                Frame frame = to_frame(render_reference(scene, load(scene), technique, size));
                for (glm::vec4 &pixel : frame.color.pixels) {
                    pixel += glm::vec4(glm::vec3(static_cast<float>(error)), 0);
                }
                return frame;
            },
            {},
            {}};
}

TEST(Stability, ErrorsWithinTheBoundPassAndBeyondItFail) {
    EXPECT_TRUE(run_stability_case(plain_case(0.5, 0.01), fake(0.009), small).passed());
    EXPECT_FALSE(run_stability_case(plain_case(0.5, 0.01), fake(0.011), small).passed());
}

TEST(Stability, ABoundOfTheBrightestValueScales) {
    StabilityCase bright = plain_case(1000, 0.01);
    EXPECT_FALSE(run_stability_case(bright, fake(5), small).passed());
    bright.unit = ErrorUnit::brightest_value;
    EXPECT_TRUE(run_stability_case(bright, fake(5), small).passed());
    EXPECT_NEAR(run_stability_case(bright, fake(5), small).rows[0].error, 0.005, 1e-6);
}

TEST(Stability, OnePixelThatIsNotFiniteFails) {
    StabilityDraw draw = fake(0);
    draw.picture = [whole = draw.picture](const Scene &scene, const Technique &technique, Size size) {
        Frame frame = whole(scene, technique, size);
        frame.color.pixels[0].r = std::numeric_limits<float>::quiet_NaN(); // background, even
        return frame;
    };
    const StabilityResult result = run_stability_case(plain_case(0.5, 1), draw, small);
    EXPECT_FALSE(result.passed());
    EXPECT_TRUE(std::isinf(result.rows[0].error));
}

TEST(Stability, WhatIsNotDrawnFails) {
    StabilityDraw draw = fake(0);
    draw.picture = [](const Scene &, const Technique &, Size size) {
        return Frame{Image(size), std::vector<std::uint32_t>(33 * 33, 0), 0};
    };
    EXPECT_FALSE(run_stability_case(plain_case(0.5, 1), draw, small).passed());
}

TEST(Stability, TheTextbookAgreesWhereNothingIsExtreme) {
    StabilityCase one = plain_case(0.1, 1e-5);
    one.techniques = {parse_technique("per-pixel/blinn-phong")};
    Light light;
    light.position = {2, 3, 4};
    light.attenuation = {1, 0.1, 0.01};
    one.scene.lights = {light};
    EXPECT_LT(run_stability_case(one, fake(0), small).textbook.error,
              3e-5); // n = 32 times float's rounding, some times
}

TEST(Stability, EveryCaseHasAStoryAndANameOfItsOwn) {
    std::set<std::string> names, groups;
    for (const StabilityCase &one : stability_cases()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        groups.insert(one.group);
        EXPECT_FALSE(one.symptom.empty() || one.cause.empty() || one.source.empty()) << one.name;
        EXPECT_FALSE(one.techniques.empty()) << one.name;
        EXPECT_GT(one.bound, 0) << one.name;
        EXPECT_LE(one.bound, 1.0 / 255) << one.name;
    }
    EXPECT_GE(names.size(), 40U);
    EXPECT_EQ(groups, (std::set<std::string>{"exponent", "geometry", "attenuation", "spot", "transform", "vertices",
                                             "placement", "magnitude", "display"}));
}

TEST(Stability, TheFilesHoldWhatWasMeasured) {
    StabilityRun run;
    run.version = "1.2.3";
    run.results = {run_stability_case(plain_case(0.5, 0.01), fake(0.02), small)};
    const auto json = nlohmann::json::parse(stability_json(run));
    EXPECT_EQ(json["cases"][0]["name"], "plain");
    EXPECT_EQ(json["cases"][0]["passed"], false);
    EXPECT_NEAR(json["cases"][0]["robust"][0]["error"].get<double>(), 0.02, 1e-6);
    EXPECT_NE(stability_csv(run).find("plain,test,robust"), std::string::npos);
    EXPECT_NE(stability_table(run).find("BROKEN"), std::string::npos);
    const std::string html = stability_html(run);
    EXPECT_NE(html.find("bound broken"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos); // nothing from elsewhere
}

} // namespace
} // namespace sandbox
