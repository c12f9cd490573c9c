#include "measure/diagnosis/candidates.h"
#include "measure/diagnosis/conventions.h"
#include "measure/diagnosis/levels.h"
#include "measure/diagnosis/linear_fit.h"
#include "measure/diagnosis/point_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <limits>

/// What a diagnosis is made of, by closed forms.
namespace sandbox {
namespace {

TEST(LinearFit, RecoversFactorsAndAMissingPart) {
    const std::vector<std::vector<double>> columns{{1, 0, 2, 1}, {0, 1, 1, 3}, {1, 1, 0, 5}};
    std::vector<double> target;
    for (std::size_t i = 0; i < 4; ++i) {
        target.push_back(0.5 * columns[0][i] + 0 * columns[1][i] + 2 * columns[2][i]);
    }
    const auto factors = fitted_factors(columns, target);
    ASSERT_TRUE(factors);
    // The pull towards 1 is a billionth of what the columns say.
    EXPECT_NEAR((*factors)[0], 0.5, 1e-5);
    EXPECT_NEAR((*factors)[1], 0, 1e-5);
    EXPECT_NEAR((*factors)[2], 2, 1e-5);
}

TEST(LinearFit, ColumnsThatCannotBeToldApartShareEvenlyAndDarkOnesStayAtOne) {
    const std::vector<double> same{1, 2, 3};
    const auto factors = fitted_factors({same, same, {0, 0, 0}}, {3, 6, 9});
    ASSERT_TRUE(factors);
    EXPECT_NEAR((*factors)[0], 1.5, 1e-5);
    EXPECT_NEAR((*factors)[1], 1.5, 1e-5);
    EXPECT_EQ((*factors)[2], 1);
    EXPECT_FALSE(fitted_factors({}, {1}));
    EXPECT_FALSE(fitted_factors({{}}, {}));
}

TEST(PointSamples, LieOnPixelCentresAroundTheMiddle) {
    for (const Size full : {Size{640, 480}, Size{321, 243}, Size{50, 1000}, Size{3, 3}}) {
        const PointSamples samples = point_samples(full, 500);
        EXPECT_LE(samples.size.width * samples.size.height, 500);
        EXPECT_EQ(samples.step % 2, 1);
        // The first is as far from the left and upper border as the last from the right and lower one.
        const auto width = static_cast<std::size_t>(full.width);
        const std::size_t first = samples.pixel(0, 0);
        const std::size_t last = samples.pixel(samples.size.width - 1, samples.size.height - 1);
        EXPECT_EQ(first % width + last % width, width - 1);
        EXPECT_EQ(first / width + last / width, static_cast<std::size_t>(full.height) - 1);
    }
}

/// A pixel of the small picture and the pixel under it look in the same direction.
TEST(PointSamples, TheirCameraLooksThroughTheSamePixelCentres) {
    const Size full{640, 478};
    const PointSamples samples = point_samples(full, 3000);
    ASSERT_GT(samples.step, 1);
    const auto slope = [](int row, int rows, double fov) { // of the ray through a row's middle
        return (1 - 2 * (row + 0.5) / rows) * std::tan(glm::radians(fov) / 2);
    };
    Camera camera;
    const Camera small = sampled_camera(camera, samples);
    const int row = static_cast<int>(samples.pixel(0, 2)) / full.width;
    EXPECT_NEAR(slope(2, samples.size.height, small.fov_y_degrees), slope(row, full.height, camera.fov_y_degrees),
                1e-14);
    camera.projection = Projection::orthographic;
    camera.height = 4;
    EXPECT_NEAR(sampled_camera(camera, samples).height, 4.0 * samples.step * samples.size.height / full.height, 1e-14);
}

TEST(Levels, AreWhatAFileHolds) {
    Image drawn({1, 1});
    drawn.pixels[0] = {0.5F, 2, -1, 1};
    EXPECT_EQ(shown_levels(drawn, {}, true), (Levels{128, 255, 0}));
    EXPECT_EQ(shown_levels(drawn, {}, false), (Levels{127.5F, 510, -255}));
    EXPECT_EQ(shown_levels(drawn, {.clamped = true}, false), (Levels{127.5F, 255, 0}));
    EXPECT_EQ(shown_levels(drawn, {.encoding = Encoding::srgb}, true), (Levels{188, 255, 0}));
    EXPECT_EQ(shown_levels(drawn, {.encoding = Encoding::gamma}, true), (Levels{186, 255, 0}));
    for (const Encoding encoding : {Encoding::linear, Encoding::srgb, Encoding::gamma}) {
        const double number = shown_levels(drawn, {.encoding = encoding}, false)[0] / 255;
        EXPECT_NEAR(decoded(number, encoding), 0.5, 1e-6); // of float32
    }
}

TEST(Levels, AFlippedPictureIsTurnedOver) {
    Observed observed{Image({1, 2}), true};
    observed.numbers.pixels[0] = glm::vec4(1);
    EXPECT_EQ(observed_levels(observed, {}), (Levels{255, 255, 255, 0, 0, 0}));
    EXPECT_EQ(observed_levels(observed, {.flipped = true}), (Levels{0, 0, 0, 255, 255, 255}));
}

TEST(Levels, DifferencesCountWhatIsComparedAndNeverForgiveWhatIsNotFinite) {
    const Levels a{0, 0, 0, 10, 10, 10, 0, 0, 0};
    const Levels b{0, 1, 0, 10, 10, 13, 90, 0, 0};
    const Difference difference = difference_of(a, b, {1, 1, 0}, 1);
    EXPECT_EQ(difference.largest, 3);
    EXPECT_EQ(difference.pixel, 1U);
    EXPECT_EQ(difference.over, 1U);
    EXPECT_EQ(difference.compared, 2U);
    EXPECT_NEAR(difference.rms, std::sqrt(10.0 / 6), 1e-12);
    const float infinite = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(std::isinf(difference_of({infinite, 0, 0}, {infinite, 0, 0}, {1}, 1).largest));
    EXPECT_TRUE(std::isinf(difference_of({NAN, 0, 0}, {0, 0, 0}, {1}, 1).largest));
}

Scene two_lights() {
    Scene scene;
    scene.ambient = glm::dvec3(0.1);
    scene.lights.resize(2);
    scene.lights[0].ambient = 0.2;
    scene.lights[1].attenuation = {1, 0.5, 0};
    scene.objects = {{"ball", SphereShape{1, 8, 16}, {}, {}, false}};
    return scene;
}

TEST(Conventions, PartsOfTheLightAddUpAndTakeFactors) {
    const Scene scene = two_lights();
    const auto all = linear_parts(scene);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].names, (std::vector<std::string>{"factor"}));
    EXPECT_EQ(all[1].names, (std::vector<std::string>{"ambient", "diffuse", "specular"}));
    EXPECT_EQ(all[2].names, (std::vector<std::string>{"lights[0]", "lights[1]"}));
    for (const LinearParts &parts : all) {
        double ambient = parts.rest.ambient.x;
        std::vector<double> diffuse(2);
        for (std::size_t i = 0; i < 2; ++i) {
            diffuse[i] = parts.rest.lights[i].diffuse;
        }
        for (const Scene &part : parts.parts) {
            ambient += part.ambient.x;
            diffuse[0] += part.lights[0].diffuse;
            diffuse[1] += part.lights[1].diffuse;
        }
        EXPECT_EQ(ambient, 0.1);
        EXPECT_EQ(diffuse, (std::vector<double>{1, 1}));
    }
    const Edit edit = with_factors(scene, all[1], {2, 1, 0.25});
    EXPECT_EQ(edit.scene.ambient.x, 0.2);
    EXPECT_EQ(edit.scene.lights[0].ambient, 0.4);
    EXPECT_EQ(edit.scene.lights[1].specular, 0.25);
    ASSERT_EQ(edit.conventions.size(), 2U);
    EXPECT_EQ(edit.conventions[0].name, "ambient=2");
    EXPECT_EQ(edit.conventions[1].name, "specular=0.25");
    EXPECT_EQ(with_factors(scene, all[2], {1, 0}).conventions.at(0).words, "the light of lights[1] is missing");
}

TEST(Conventions, FactorsArePlainNumbers) {
    EXPECT_EQ(plain_factor(0.99998, 1), 1);
    EXPECT_EQ(plain_factor(-0.7, 10), 0);
    EXPECT_EQ(plain_factor(1.9981, 10), 2);
    EXPECT_EQ(plain_factor(0.7031, 10), 0.7);
    EXPECT_EQ(plain_factor(0.7031, 1000), 0.703);
}

TEST(Conventions, EditsAreThoseThatTheSceneCanShow) {
    std::vector<std::string> names;
    for (const Edit &edit : scene_edits(two_lights())) {
        names.push_back(edit.conventions.at(0).name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"attenuation=none"}));
    EXPECT_TRUE(scene_edits(Scene{}).empty());
}

std::vector<ObjectResources> load(const Scene &scene) {
    return {{std::make_shared<const Mesh>(build_mesh(scene.objects[0].mesh)), nullptr}};
}

TEST(Candidates, AreValidHaveAnEffectAndDrawDifferently) {
    const Scene scene = two_lights();
    const auto bases = base_techniques(std::nullopt);
    EXPECT_EQ(bases.size(), (all_frequencies.size() - 1) * all_models.size()) << "auto looks like per-pixel";
    std::vector<Technique> all;
    for (const Candidate &candidate : single_candidates(scene, load(scene), bases)) {
        EXPECT_EQ(candidate.same.front(), candidate.technique);
        for (const Technique &technique : candidate.same) {
            EXPECT_FALSE(why_refused(technique)) << to_string(technique);
            EXPECT_TRUE(settings_without_effect(scene, technique).empty()) << to_string(technique);
            EXPECT_EQ(std::ranges::count(all, technique), 0) << to_string(technique);
            all.push_back(technique);
        }
    }
    EXPECT_EQ(std::ranges::count(all, parse_technique("per-vertex/phong:gate=none")), 1);
    EXPECT_EQ(std::ranges::count(all, parse_technique("per-vertex/phong:normals=model-matrix")), 0) << "nothing turned";
    EXPECT_EQ(std::ranges::count(all, parse_technique("per-pixel/phong:power=textbook")), 0) << "the same equation";
}

TEST(Candidates, AGivenTechniqueKeepsItsVariantsAndLosesItsFaults) {
    const auto bases = base_techniques(parse_technique("per-pixel/blinn-phong:gate=none,normalisation=blinn-phong"));
    ASSERT_EQ(bases.size(), 1U);
    EXPECT_EQ(to_string(bases[0]), "per-pixel/blinn-phong:normalisation=blinn-phong");
}

TEST(Candidates, OwnShadingTellsItsFrequencyAlone) {
    const Technique own{.frequency = Frequency::per_vertex, .model = Model::own};
    const auto bases = base_techniques(own);
    ASSERT_EQ(bases.size(), all_models.size());
    for (const Technique &base : bases) {
        EXPECT_EQ(base.frequency, Frequency::per_vertex);
        EXPECT_NE(base.model, Model::own);
    }
}

TEST(Candidates, PairsHaveTwoFaultsOfTwoKeys) {
    const Scene scene = two_lights();
    const auto pairs = pair_candidates(scene, load(scene), {parse_technique("per-pixel/phong")});
    EXPECT_FALSE(pairs.empty());
    for (const Candidate &pair : pairs) {
        EXPECT_EQ(std::ranges::count_if(technique_settings,
                                        [&](const TechniqueKey &key) { return key.get(pair.technique) != 0; }),
                  2);
        EXPECT_EQ(pair.faults, 2U);
    }
}

} // namespace
} // namespace sandbox
