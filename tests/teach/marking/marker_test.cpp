#include "image/error.h"
#include "teach/marking/marking_fakes.h"
#include "teach/marking/sentences.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>

/// Answers are pictures of the reference, of scenes that were changed as a fault would change them.
namespace sandbox {
namespace {

const std::string all_terms = R"([{"term": "ambient", "points": 1}, {"term": "diffuse", "points": 2},
    {"term": "specular", "points": 3}, {"term": "attenuation", "points": 4}, {"term": "sum", "points": 5}])";

const OwnShader some_text("a.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return P + N + eye; }");

using Change = std::function<void(Scene &)>;

/// What each term costs an answer that sees scenes so changed, in the words of the exercise.
std::map<std::string, double> lost(const Exercise &exercise, const Change &change,
                                   const std::string &technique = "per-pixel/phong",
                                   const std::function<void(Image &)> &after = {}) {
    FakeDraw *self = nullptr;
    FakeDraw fake([&](const Scene &scene, const Technique &, Size size) {
        Scene seen = scene;
        if (change) {
            change(seen);
        }
        Image image = self->truth(seen, technique, size);
        if (after) {
            after(image);
        }
        return image;
    });
    self = &fake;
    Marker marker(exercise, fake.draw);
    const Mark mark = marker.mark_own(some_text);
    EXPECT_EQ(mark.refused, "");
    std::map<std::string, double> costs;
    for (std::size_t i = 0; i < mark.judgement.terms.size(); ++i) {
        const double cost = exercise.terms[i].points - points_of(exercise.terms[i], mark.judgement.terms[i]);
        if (cost != 0) {
            costs[std::string(term_words[static_cast<std::size_t>(exercise.terms[i].term)])] = cost;
        }
    }
    return costs;
}
using Costs = std::map<std::string, double>;

TEST(Marker, TheTruthLosesNothing) { EXPECT_EQ(lost(small_exercise(all_terms), {}), Costs{}); }

/// One error costs once: each of these touches every picture of the whole scene.
TEST(Marker, OneErrorCostsItsTermAlone) {
    const Exercise exercise = small_exercise(all_terms);
    const auto of_lights = [](const std::function<void(Light &)> &change) {
        return [change](Scene &scene) {
            for (Light &light : scene.lights) {
                change(light);
            }
        };
    };
    EXPECT_EQ(lost(exercise, of_lights([](Light &l) { l.ambient = 0; })), (Costs{{"ambient", 0.5}}))
        << "the scene's own ambient light is there: half of its pictures";
    EXPECT_EQ(lost(exercise, of_lights([](Light &l) { l.diffuse *= 2; })), (Costs{{"diffuse", 2}}));
    EXPECT_EQ(lost(exercise, of_lights([](Light &l) { l.specular *= 0.5; })), (Costs{{"specular", 3}}));
    EXPECT_EQ(lost(exercise, of_lights([](Light &l) { l.attenuation = {}; })), (Costs{{"attenuation", 4}}));
    EXPECT_EQ(lost(exercise, {}, "per-pixel/blinn-phong"), (Costs{{"specular", 3}}));
    EXPECT_EQ(lost(exercise, {}, "per-pixel/phong:viewer=infinite"), (Costs{{"specular", 3}}));
}

/// A wrong diffuse term does not hide that attenuation is right, nor the other way round.
TEST(Marker, TwoErrorsCostTwice) {
    EXPECT_EQ(lost(small_exercise(all_terms),
                   [](Scene &scene) {
                       scene.lights[0].diffuse *= 0.5;
                       scene.lights[0].attenuation.quadratic = 0;
                   }),
              (Costs{{"diffuse", 2}, {"attenuation", 4}}));
}

TEST(Marker, ConesAreJudgedByTheirRatio) {
    const Exercise exercise = small_exercise(R"([{"term": "diffuse", "points": 2}, {"term": "cone", "points": 4}])",
                                             "per-pixel/phong", R"([{"scene": "spot-light"}])");
    EXPECT_EQ(lost(exercise, {}), Costs{});
    EXPECT_EQ(lost(exercise, [](Scene &s) { s.lights[0].inner_cutoff_degrees = s.lights[0].cutoff_degrees; }),
              (Costs{{"cone", 4}}));
    EXPECT_EQ(lost(exercise, [](Scene &s) { s.lights[0].exponent = 0; }), (Costs{{"cone", 4}}));
    EXPECT_EQ(lost(exercise, [](Scene &s) { s.lights[0].diffuse *= 0.5; }), (Costs{{"diffuse", 2}}));
}

TEST(Marker, NormalsAreJudgedUnderTheTransformAlone) {
    const Exercise exercise =
        small_exercise(R"([{"term": "diffuse", "points": 2}, {"term": "normals", "points": 4}])", "per-pixel/lambert",
                       R"([{"scene": "box-4-normal-matrix", "set": ["objects[0].transform.scale=[0.5,1.5,1]",
                                                    "objects[0].transform.rotate_degrees=[20,30,0]"]}])");
    EXPECT_EQ(lost(exercise, {}, "per-pixel/lambert"), Costs{});
    EXPECT_EQ(lost(exercise, {}, "per-pixel/lambert:normals=model-matrix"), (Costs{{"normals", 4}}));
    EXPECT_EQ(lost(exercise, {}, "per-pixel/lambert:normals=untransformed"), (Costs{{"normals", 4}}));
    EXPECT_EQ(lost(
                  exercise, [](Scene &s) { s.lights[0].diffuse *= 0.5; }, "per-pixel/lambert"),
              (Costs{{"diffuse", 2}, {"normals", 4}}))
        << "no term is right by which normals could be seen";
}

TEST(Marker, WhatIsDoneToTheSumCostsTheSum) {
    const Exercise exercise = small_exercise(all_terms, "per-pixel/phong", R"([{"scene": "three-point-lights"}])");
    EXPECT_EQ(lost(exercise, {}), Costs{});
    const auto first_alone = [](Scene &scene) {
        for (std::size_t i = 1; i < scene.lights.size(); ++i) {
            scene.lights[i].enabled = false;
        }
    };
    EXPECT_EQ(lost(exercise, first_alone), (Costs{{"sum", 5}}));
    EXPECT_EQ(lost(exercise, {}, "per-pixel/phong",
                   [](Image &image) {
                       for (glm::vec4 &pixel : image.pixels) {
                           for (int c = 0; c < 3; ++c) {
                               pixel[c] = std::pow(pixel[c], 1 / 2.2F);
                           }
                       }
                   }),
              (Costs{{"sum", 5}}))
        << "encoded for a screen";
}

/// Light that is there in the dark is ambient light, unless a term does not heed its intensity.
TEST(Marker, LightInTheDarkCostsOnce) {
    const Exercise exercise = small_exercise(all_terms);
    EXPECT_EQ(lost(exercise, {}, "per-pixel/phong",
                   [](Image &image) {
                       for (glm::vec4 &pixel : image.pixels) {
                           pixel += glm::vec4(0.1F, 0.1F, 0.1F, 0);
                       }
                   }),
              (Costs{{"ambient", 1}}));
    const Costs unheeding = lost(exercise, [](Scene &scene) { scene.lights[0].diffuse = 0.85; });
    EXPECT_FALSE(unheeding.contains("ambient")) << "its pictures shine in the dark, too";
    EXPECT_EQ(unheeding.at("diffuse"), 2);
}

TEST(Marker, NothingGetsNothing) {
    const Exercise exercise = small_exercise(
        R"([{"term": "ambient"}, {"term": "diffuse"}, {"term": "sum"}, {"term": "robustness"}])", "per-pixel/lambert",
        R"([{"scene": "point-light"}, {"set": ["lights[0].diffuse=1e6"], "stiff": true}])");
    const Costs costs = lost(exercise, {}, "per-pixel/lambert",
                             [](Image &image) { std::ranges::fill(image.pixels, glm::vec4(0, 0, 0, 1)); });
    EXPECT_EQ(costs, (Costs{{"ambient", 1}, {"diffuse", 1}, {"sum", 1}, {"robustness", 1}}));
}

TEST(Marker, APixelThatIsNotFiniteCostsRobustnessAlone) {
    const Exercise exercise =
        small_exercise(R"([{"term": "diffuse"}, {"term": "robustness"}])", "per-pixel/lambert",
                       R"([{"scene": "point-light"}, {"set": ["lights[0].diffuse=1e6"], "stiff": true}])");
    const auto spoil = [](Image &image) { image.at(24, 18).x = std::numeric_limits<float>::quiet_NaN(); };
    EXPECT_EQ(lost(exercise, {}, "per-pixel/lambert", spoil), (Costs{{"robustness", 1}}));
    EXPECT_EQ(lost(exercise, {}, "per-pixel/lambert"), Costs{});
}

/// ... also where it is in a plain scene, and the stiff ones are finite.
TEST(Marker, APixelThatIsNotFiniteInAPlainSceneCostsRobustness) {
    const Exercise exercise =
        small_exercise(R"([{"term": "diffuse"}, {"term": "robustness"}])", "per-pixel/lambert",
                       R"([{"scene": "point-light"}, {"set": ["lights[0].diffuse=1e6"], "stiff": true}])");
    FakeDraw *self = nullptr;
    FakeDraw fake([&](const Scene &scene, const Technique &, Size size) {
        Image image = self->truth(scene, "per-pixel/lambert", size);
        image.at(24, 18).x = scene.lights[0].diffuse == 1e6 ? 0 : std::numeric_limits<float>::infinity();
        return image;
    });
    self = &fake;
    Marker marker(exercise, fake.draw);
    EXPECT_EQ(marker.mark_own(some_text).judgement.points(exercise), 1);
}

TEST(Marker, WhatCannotBeSeenYetSaysWhatToMendFirst) {
    const Exercise exercise = small_exercise(R"([{"term": "diffuse"}, {"term": "normals"}])", "per-pixel/lambert",
                                             R"([{"scene": "box-4-normal-matrix"}])");
    FakeDraw *self = nullptr;
    FakeDraw fake([&](const Scene &scene, const Technique &, Size size) {
        Scene dim = scene;
        dim.lights[0].diffuse *= 0.5;
        return self->truth(dim, "per-pixel/lambert", size);
    });
    self = &fake;
    Marker marker(exercise, fake.draw);
    const auto said = sentences(english, exercise, marker.mark_own(some_text), 1);
    ASSERT_EQ(said.size(), 2U);
    EXPECT_EQ(said[1], "normals: cannot be seen yet; first mend diffuse");
}

TEST(Marker, AnAnswerThatFailsIsRefusedWithItsReason) {
    const Exercise exercise = small_exercise(all_terms);
    FakeDraw fake([](const Scene &, const Technique &, Size) -> Image { throw InputError("a.glsl:3: no such name"); });
    Marker marker(exercise, fake.draw);
    const Mark mark = marker.mark_own(some_text);
    EXPECT_EQ(mark.refused, "a.glsl:3: no such name");
    EXPECT_EQ(mark.judgement.points(exercise), 0);
    EXPECT_EQ(sentences(english, exercise, mark, 0), std::vector<std::string>{"Not marked: a.glsl:3: no such name"});
}

TEST(Marker, WordsMayBeAskedForAndForbidden) {
    Exercise exercise = small_exercise(all_terms);
    FakeDraw fake([](const Scene &, const Technique &, Size size) { return Image(size); });
    Marker marker(exercise, fake.draw);
    exercise.has = {"lighting", "normal"};
    EXPECT_EQ(marker.mark_own(some_text).refused, "a.glsl: the exercise asks for 'normal', which is not in it");
    exercise.has = {};
    exercise.lacks = {"eye"};
    EXPECT_EQ(marker.mark_own(some_text).refused, "a.glsl: the exercise asks to do without 'eye'");
    exercise.lacks = {"normal_matrix"};
    EXPECT_EQ(marker.mark_own(some_text).refused, "");
}

TEST(Marker, HintsSayMoreStepByStep) {
    const Exercise exercise = small_exercise(all_terms);
    FakeDraw *self = nullptr;
    FakeDraw fake([&](const Scene &scene, const Technique &, Size size) {
        return self->truth(scene, "per-pixel/phong:gate=times-n-dot-l", size);
    });
    self = &fake;
    Marker marker(exercise, fake.draw);
    const Mark mark = marker.mark_own(some_text);
    std::size_t length = 0;
    EXPECT_TRUE(sentences(english, exercise, mark, 0).empty());
    for (int hints = 1; hints <= most_hints; ++hints) {
        const auto said = sentences(english, exercise, mark, hints);
        ASSERT_EQ(said.size(), 1U);
        EXPECT_TRUE(said[0].starts_with("specular: wrong in the scene \"lamp\", most at pixel (")) << said[0];
        EXPECT_GT(said[0].size(), length);
        length = said[0].size();
    }
    EXPECT_NE(sentences(english, exercise, mark, 3)[0].find("specular gate: times N.L"), std::string::npos);
}

TEST(Marker, PicturesAreDiagnosed) {
    const Exercise exercise = small_exercise(all_terms);
    FakeDraw fake([](const Scene &, const Technique &, Size size) { return Image(size); });
    Marker marker(exercise, fake.draw);
    const auto points = [&](const Image &picture) {
        const Mark mark = marker.mark_picture({picture, false});
        return mark.unknown ? -1 : mark.judgement.points(exercise);
    };
    const Scene &scene = exercise.shown_scene();
    EXPECT_EQ(points(fake.truth(scene, "per-pixel/phong", {64, 48})), 15);
    EXPECT_EQ(points(fake.truth(scene, "per-pixel/phong:gate=times-n-dot-l", {64, 48})), 12);
    Scene dim = scene;
    dim.lights[0].attenuation = {};
    EXPECT_EQ(points(fake.truth(dim, "per-pixel/phong", {64, 48})), 11);
    EXPECT_NE(marker.mark_picture({Image({4000, 4000}), true}).refused, "");
}

} // namespace
} // namespace sandbox
