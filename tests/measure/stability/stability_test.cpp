#include "image/device_limit.h"
#include "measure/report/stability_report.h"
#include "reference/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

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

TEST(Stability, WhatTheDeviceCannotDrawIsRefusedAndNoFailure) {
    StabilityCase one = plain_case(0.5, 0.01);
    one.name = "many-lights";
    one.techniques.push_back(parse_technique("per-pixel/lambert:program=full"));
    const auto run = [&](double error) {
        StabilityDraw draw = fake(error);
        draw.picture = [drawn = draw.picture](const Scene &scene, const Technique &technique, Size size) {
            if (technique.program == Program::full) {
                throw DeviceLimitError("too large");
            }
            return drawn(scene, technique, size);
        };
        return StabilityRun{{run_stability_case(one, draw, small)}, "device", "1"};
    };
    const StabilityRun refused = run(0);
    EXPECT_TRUE(refused.results[0].passed());
    EXPECT_EQ(refused.results[0].rows[1].refused, "too large");
    EXPECT_EQ(&refused.results[0].worst(), &refused.results[0].rows[0]);
    EXPECT_EQ(nlohmann::json::parse(stability_json(refused))["cases"][0]["robust"][1]["refused"], "too large");
    for (const std::string &text : {stability_table(refused), stability_csv(refused), stability_html(refused)}) {
        EXPECT_NE(text.find("too large"), std::string::npos) << text;
    }
    EXPECT_FALSE(run(0.1).results[0].passed()) << "what is drawn is judged";
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

/// 65504 is the largest half float; values from 65520 round to infinity. Float32 has room to spare.
TEST(Stability, HalfFloatsEndWhereTheyEnd) {
    for (const auto &[ambient, target, breaks] :
         {std::tuple(65000.0, TextbookTarget::half, false), std::tuple(66000.0, TextbookTarget::half, true),
          std::tuple(66000.0, TextbookTarget::float32, false), std::tuple(1e-9, TextbookTarget::half, true)}) {
        StabilityCase one = plain_case(ambient, 1e-3); // half floats keep 11 bits: 5e-4
        one.unit = ErrorUnit::brightest_value;
        one.textbook_target = target;
        const StabilityResult result = run_stability_case(one, fake(0), small);
        EXPECT_EQ(result.textbook_breaks(), breaks) << ambient;
        EXPECT_TRUE(result.passed()) << "the textbook's target is not the program's";
    }
}

/// normalize(0) at one vertex, which all triangles around it share; elsewhere there is nothing to go wrong.
TEST(Stability, ATextbookPerVertexSpreadsWhatOneVertexLoses) {
    StabilityCase one = plain_case(0, 1);
    one.scene.objects[0].mesh = PlaneShape{.size = {2, 2}, .divisions = 2};
    one.scene.camera.position = {0, 3, 0};
    one.scene.camera.up = {0, 0, -1};
    one.scene.lights = {Light{}};
    one.scene.lights[0].position = {0, 0, 0};
    for (const auto &[technique, least, most] :
         {std::tuple("per-pixel/lambert", 1, 1), std::tuple("per-vertex/lambert", 100, 33 * 33)}) {
        one.techniques = {parse_technique(technique)};
        const auto lost = run_stability_case(one, fake(0), small).textbook.metrics.nonfinite_pixels;
        EXPECT_GE(lost, static_cast<std::size_t>(least)) << technique;
        EXPECT_LE(lost, static_cast<std::size_t>(most)) << technique;
    }
}

/// A wall two units behind the eye's near plane of 1e-9 has the depth 1, which is that of nothing at all.
TEST(Stability, ATextbooksDepthsEndBeforeTheScene) {
    StabilityCase one = plain_case(0.5, 0.01);
    EXPECT_TRUE(run_stability_case(one, fake(0), small).textbook.passed);
    one.scene.camera.near_plane = 1e-9;
    const StabilityResult result = run_stability_case(one, fake(0), small);
    EXPECT_TRUE(result.textbook_breaks());
    EXPECT_GT(result.textbook.metrics.silhouette_pixels, 20U);
}

TEST(Stability, CasesAreListedByWhetherTheTextbookBreaks) {
    StabilityCase dark = plain_case(1e-9, 1e-3);
    dark.name = "dark";
    dark.unit = ErrorUnit::brightest_value;
    dark.textbook_target = TextbookTarget::half;
    StabilityCase whole = plain_case(0.5, 0.01);
    whole.name = "whole";
    whole.seen_on = "a phone";
    StabilityRun run;
    run.results = {run_stability_case(whole, fake(0), small), run_stability_case(dark, fake(0), small)};
    const auto json = nlohmann::json::parse(stability_json(run));
    EXPECT_EQ(json["textbook_breaks"], 1);
    EXPECT_EQ(json["nothing_breaks"], 1);
    EXPECT_EQ(json["cases"][0]["textbook_breaks"], false);
    EXPECT_EQ(json["cases"][0]["seen_on"], "a phone");
    EXPECT_EQ(json["cases"][1]["textbook_breaks"], true);
    EXPECT_EQ(json["cases"][1]["textbook_form"], "float32 on the processor, per pixel, kept in half floats");
    for (const std::string &text : {stability_table(run), stability_html(run)}) {
        const auto first = text.find("The textbook's form breaks on this renderer: 1");
        const auto second = text.find("Nothing breaks on this renderer: 1");
        ASSERT_NE(first, std::string::npos) << text.substr(0, 1000);
        ASSERT_NE(second, std::string::npos);
        EXPECT_LT(first, text.find("dark", first));
        EXPECT_LT(text.find("dark", first), second) << "though it was run last";
        EXPECT_LT(second, text.find("whole", second));
        EXPECT_NE(text.find("seen on: a phone"), std::string::npos);
    }
}

/// The first technique's truth judges the textbook's form.
TEST(Stability, TheTextbooksFormIsOfTheFirstTechniquesKind) {
    for (const StabilityCase &one : stability_cases()) {
        if (one.textbook) {
            EXPECT_EQ(one.textbook->frequency, one.techniques.front().frequency) << one.name;
            EXPECT_EQ(one.textbook->model, one.techniques.front().model) << one.name;
        }
    }
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

/// Stories are translated by their own words; files for programs stay English.
TEST(Stability, ThePageIsInItsLanguage) {
    StabilityCase told = plain_case(0.5, 0.01);
    told.symptom = "The picture is black.";
    told.cause = "a cause that nobody has translated";
    StabilityRun run;
    run.words = words_in("zh");
    run.results = {run_stability_case(told, fake(0.02), small)};
    const std::string html = stability_html(run);
    for (const char *text : {"症状", "画面全黑。", "a cause that nobody has translated", "超出界限"}) {
        EXPECT_NE(html.find(text), std::string::npos) << text;
    }
    for (const char *text : {"Symptom", "The picture is black.", "bound broken"}) {
        EXPECT_EQ(html.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(nlohmann::json::parse(stability_json(run))["cases"][0]["symptom"], "The picture is black.");
}

} // namespace
} // namespace sandbox
