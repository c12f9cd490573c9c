#include "reference/lighting.h"

#include "reference/reference_scenes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace sandbox::reference {
namespace {

constexpr double degree = std::numbers::pi / 180;
/// A few roundings of double: each value here is a handful of operations on numbers near 1.
constexpr double tight = 1e-14;

/// The equation at one world-space point of a scene with one light.
struct Spot {
    Scene scene;
    Technique technique;
    glm::dvec3 point{0};
    glm::dvec3 normal{0, 1, 0};
    double shininess = 10;

    Spot() {
        scene.camera.position = {0, 10, 0};
        scene.camera.target = {0, 0, 0};
        scene.lights.push_back(test::point_light({0, 2, 0}));
        scene.lights[0].ambient = 0.25;
        scene.lights[0].diffuse = 0.5;
        scene.lights[0].specular = 0.75;
    }
    Light &light() { return scene.lights[0]; }
    /// Light and eye at angles from the normal, in the plane z = 0: the light to the left, the eye to the right.
    void angles(double light_angle, double eye_angle) {
        light().position = {-2 * std::sin(light_angle), 2 * std::cos(light_angle), 0};
        scene.camera.position = {5 * std::sin(eye_angle), 5 * std::cos(eye_angle), 0};
    }
    [[nodiscard]] LightTerms terms() const {
        const Setup setup = prepare(scene, technique);
        const glm::dvec3 p = point - setup.eye;
        const glm::dvec3 v = view_vector(setup, p);
        const LightVectors vectors = light_vectors(setup, setup.lights[0], p, normal, v);
        return light_terms(setup, setup.lights[0], vectors, normal, v, shininess);
    }
};

TEST(Lighting, HeadOnEverythingIsFull) {
    for (const Model model : {Model::phong, Model::blinn_phong}) {
        Spot spot;
        spot.technique.model = model;
        spot.light().color = {1, 0.5, 0.25};
        const LightTerms t = spot.terms();
        EXPECT_NEAR(t.ambient.x, 0.25, tight);
        EXPECT_NEAR(t.diffuse.y, 0.25, tight);
        EXPECT_NEAR(t.specular.z, 0.75 * 0.25, tight);
        EXPECT_DOUBLE_EQ(t.vectors.d, 2);
    }
}

TEST(Lighting, PhongAndBlinnAtKnownAngles) {
    Spot spot;
    spot.angles(50 * degree, 30 * degree);
    spot.technique.model = Model::phong;
    EXPECT_NEAR(spot.terms().f, std::cos(20 * degree), tight);
    EXPECT_NEAR(spot.terms().specular.x, 0.75 * std::pow(std::cos(20 * degree), 10), tight);
    spot.technique.model = Model::blinn_phong;
    EXPECT_NEAR(spot.terms().f, std::cos(10 * degree), tight);
    EXPECT_NEAR(spot.terms().diffuse.x, 0.5 * std::cos(50 * degree), tight);
    spot.scene.blinn_exponent_scale = 4;
    EXPECT_NEAR(spot.terms().f_power, std::pow(std::cos(10 * degree), 40), tight);
    EXPECT_EQ(spot.terms().exponent, 40);
}

TEST(Lighting, LambertHasNoHighlight) {
    Spot spot;
    spot.technique.model = Model::lambert;
    EXPECT_EQ(spot.terms().specular, glm::dvec3(0));
}

TEST(Lighting, BehindTheTerminatorOnlyTheAmbientTermIsLeft) {
    Spot spot;
    spot.angles(100 * degree, 60 * degree);
    EXPECT_EQ(spot.terms().diffuse, glm::dvec3(0));
    EXPECT_EQ(spot.terms().specular, glm::dvec3(0));
    EXPECT_EQ(spot.terms().ambient.x, 0.25);
}

TEST(Lighting, GatesDecideAboutTheHighlightAlone) {
    Spot spot;
    spot.angles(100 * degree, 60 * degree);
    const double highlight = 0.75 * std::pow(std::cos(20 * degree), 10);
    spot.technique.gate = Gate::view_facing;
    EXPECT_NEAR(spot.terms().specular.x, highlight, tight);
    spot.angles(70 * degree, 100 * degree);
    EXPECT_EQ(spot.terms().specular.x, 0);
    spot.technique.gate = Gate::none;
    EXPECT_NEAR(spot.terms().specular.x, 0.75 * std::pow(std::cos(15 * degree), 10), tight);
    spot.technique.gate = Gate::light_facing;
    EXPECT_NEAR(spot.terms().specular.x, 0.75 * std::pow(std::cos(15 * degree), 10), tight);
    spot.technique.gate = Gate::times_n_dot_l;
    EXPECT_NEAR(spot.terms().specular.x, 0.75 * std::pow(std::cos(15 * degree), 10) * std::cos(70 * degree), tight);
    spot.angles(100 * degree, 60 * degree);
    EXPECT_EQ(spot.terms().specular.x, 0);
}

TEST(Lighting, TheGateShutsAtTheTerminatorAndCosinesEndAtZero) {
    Spot spot;
    spot.angles(90.02 * degree, 60 * degree); // N.L = -3e-4
    EXPECT_EQ(spot.terms().specular, glm::dvec3(0));
    spot.angles(89.98 * degree, 60 * degree);
    EXPECT_GT(spot.terms().specular.x, 0);
    spot.technique.model = Model::phong;
    spot.angles(80 * degree, -30 * degree); // R and V are 110 degrees apart
    EXPECT_EQ(spot.terms().f, 0);
}

TEST(Lighting, NormalisationScalesDiffuseAndHighlight) {
    Spot spot; // Blinn-Phong
    spot.angles(50 * degree, 30 * degree);
    const LightTerms plain = spot.terms();
    spot.technique.normalisation = Normalisation::blinn_phong;
    spot.scene.blinn_exponent_scale = 4; // n as raised: 40
    const double pi = std::numbers::pi;
    EXPECT_NEAR(spot.terms().diffuse.x, plain.diffuse.x / pi, tight);
    EXPECT_NEAR(spot.terms().specular.x, 0.75 * std::pow(std::cos(10 * degree), 40) * 48 / (8 * pi), tight);
    EXPECT_EQ(spot.terms().ambient, plain.ambient);
}

TEST(Lighting, AttenuationFallsWithDistanceAndIsFloored) {
    Spot spot;
    spot.light().attenuation = {0.5, 0.25, 0.125};
    EXPECT_NEAR(spot.terms().vectors.a, 1 / (0.5 + 0.5 + 0.5), tight);
    EXPECT_NEAR(spot.terms().diffuse.x, 0.5 / 1.5, tight);
    EXPECT_EQ(spot.terms().ambient.x, 0.25);
    spot.light().attenuate_ambient = true;
    EXPECT_NEAR(spot.terms().ambient.x, 0.25 / 1.5, tight);
    EXPECT_DOUBLE_EQ(attenuation({0, 1, 0}, 0), 1e6);
    EXPECT_DOUBLE_EQ(attenuation({1e-30, 0, 1e-30}, 1), 1e6);
    EXPECT_NEAR(attenuation({0, 0, 1e9}, 1e9) * 1e27, 1, tight);
}

TEST(Lighting, DirectionalLightKnowsNoDistance) {
    Spot spot;
    spot.scene.lights[0].type = LightType::directional;
    spot.light().direction = {0, -3, 0};
    spot.light().attenuation = {7, 7, 7};
    spot.point = {100, 0, -40};
    EXPECT_EQ(spot.terms().vectors.l, glm::dvec3(0, 1, 0));
    EXPECT_EQ(spot.terms().diffuse.x, 0.5);
}

TEST(Lighting, SpotIsCutAtItsEdge) {
    Spot spot;
    spot.light().type = LightType::spot;
    spot.light().position = {0, 1, 0};
    spot.light().direction = {0, -2, 0};
    spot.light().cutoff_degrees = spot.light().inner_cutoff_degrees = 30;
    spot.light().exponent = 8;
    const double c = std::cos(29.9 * degree);
    spot.point = {std::tan(29.9 * degree), 0, 0};
    EXPECT_NEAR(spot.terms().s, std::pow(c, 8), tight);
    EXPECT_NEAR(spot.terms().diffuse.x, 0.5 * c * std::pow(c, 8), tight);
    spot.point = {std::tan(30.1 * degree), 0, 0};
    EXPECT_EQ(spot.terms().s, 0);
    EXPECT_EQ(spot.terms().diffuse.x, 0);
    EXPECT_NEAR(spot.terms().s_uncut, std::pow(std::cos(30.1 * degree), 8), tight);
}

TEST(Lighting, InnerConeFadesBySmoothstep) {
    Spot spot;
    spot.light().type = LightType::spot;
    spot.light().position = {0, 1, 0};
    spot.light().cutoff_degrees = 40;
    spot.light().inner_cutoff_degrees = 20;
    // Halfway between the two cosines smoothstep is 1/2, at a quarter 5/32.
    const double outer = std::cos(40 * degree);
    const double inner = std::cos(20 * degree);
    for (const auto &[share, factor] : {std::pair{0.5, 0.5}, std::pair{0.25, 5.0 / 32}, std::pair{1.0, 1.0}}) {
        spot.point = {std::tan(std::acos(outer + share * (inner - outer))), 0, 0};
        EXPECT_NEAR(spot.terms().s, factor, 1e-13); // acos and tan lose a digit
    }
}

TEST(Lighting, CutoffOf180DropsTheExponentAnd90KeepsIt) {
    Spot spot;
    spot.light().type = LightType::spot;
    spot.light().direction = {1, -1, 0};
    spot.light().exponent = 2;
    spot.light().cutoff_degrees = spot.light().inner_cutoff_degrees = 180;
    EXPECT_EQ(spot.terms().s, 1);
    spot.light().cutoff_degrees = spot.light().inner_cutoff_degrees = 90;
    EXPECT_NEAR(spot.terms().s, 0.5, tight);
    spot.light().direction = {1, 1e-9, 0};
    EXPECT_EQ(spot.terms().s, 0);
}

TEST(Lighting, ZeroToThePowerOfZeroIsOne) {
    EXPECT_EQ(power_of_dot({1, 0, 0}, {0, 1, 0}, 0), 1);
    EXPECT_EQ(power_of_dot({1, 0, 0}, {-1, 0, 0}, 0), 1);
    EXPECT_EQ(power_of_dot({1, 0, 0}, {0, 1, 0}, 1e-3), 0);
}

TEST(Lighting, DegenerateVectorsHaveTheirDefinedValues) {
    Spot at_light;
    at_light.light().position = at_light.point;
    EXPECT_EQ(at_light.terms().vectors.l, at_light.normal);
    Spot opposite;
    opposite.light().type = LightType::directional;
    opposite.light().direction = {0, 1, 0};
    EXPECT_EQ(opposite.terms().vectors.h, opposite.normal);
    Spot at_eye;
    at_eye.scene.camera.position = at_eye.point;
    at_eye.scene.camera.target = {0, 0, -1};
    EXPECT_TRUE(std::isfinite(at_eye.terms().specular.x));
    EXPECT_EQ(unit(glm::dvec3(0)), glm::dvec3(0));
    EXPECT_EQ(unit({3e-200, 0, 4e-200}), glm::dvec3(0.6, 0, 0.8));
    EXPECT_EQ(unit({3e200, 0, 4e200}), glm::dvec3(0.6, 0, 0.8));
}

/// cos(e)^n = exp(n log cos e), log cos e = -e^2/2 - e^4/12 - e^6/45 ...: a series that needs no cosine.
TEST(Lighting, StiffPowersKeepTheirDigits) {
    for (const double n : {1e3, 1e5, 1e7}) {
        for (const double angle : {1e-5, 1e-4, 1e-3, 3e-2}) {
            const glm::dvec3 a(std::sin(angle), std::cos(angle), 0);
            const double e2 = angle * angle;
            const double expected = std::exp(-n * e2 * (0.5 + e2 * (1.0 / 12 + e2 * (1.0 / 45 + e2 * 17 / 2520))));
            // The vectors' own rounding, 1e-16, turns the angle: n * angle * 1e-16, twice for two components.
            const double tolerance = expected * (1e-14 + 4e-16 * n * angle) + 1e-300;
            EXPECT_NEAR(power_of_dot(a, {0, 1, 0}, n), expected, tolerance) << "n " << n << " angle " << angle;
        }
    }
    EXPECT_EQ(power_of_dot({0.6, 0.8, 0}, {0.6, 0.8, 0}, 1e7), 1);
    EXPECT_NEAR(power_of_dot({0, 0.5, 0}, {0, 1, 0}, 20), std::pow(0.5, 20), 1e-20);
    EXPECT_NEAR(power_of_dot({0.5, 0, 0}, {0.02, 1, 0}, 2), 1e-4, 1e-17);
}

TEST(Lighting, InfiniteViewerLooksAlongTheAxisEverywhere) {
    Spot spot;
    spot.technique.viewer = Viewer::infinite;
    spot.technique.model = Model::phong;
    spot.point = {3, 0, 0};
    spot.light().position = {3, 2, 0};
    EXPECT_NEAR(spot.terms().f, 1, tight); // V = (0, 1, 0) though the eye is at an angle
    spot.technique.viewer = Viewer::local;
    EXPECT_NEAR(spot.terms().f, 10 / std::sqrt(109.0), tight);
}

TEST(Lighting, ConstantHalfVectorIsSeenFromTheOrigin) {
    Spot spot;
    spot.technique.half_vector = HalfVector::constant;
    spot.light().position = {2, 0, 0};
    spot.point = {-5, 0, 7};
    // unit(light) = (1, 0, 0), view axis (0, 1, 0): H lies halfway wherever the point is.
    EXPECT_NEAR(spot.terms().f, std::sqrt(0.5), tight);
    spot.light().type = LightType::directional;
    spot.light().direction = {0, 0, -5};
    EXPECT_NEAR(glm::length(spot.terms().vectors.h - glm::dvec3(0, std::sqrt(0.5), std::sqrt(0.5))), 0, tight);
}

TEST(Lighting, AmbientWhereLitNeedsTheLightInFront) {
    Spot spot;
    spot.technique.ambient = AmbientWhere::where_lit;
    EXPECT_EQ(spot.terms().ambient.x, 0.25);
    spot.angles(95 * degree, 0);
    EXPECT_EQ(spot.terms().ambient.x, 0);
}

TEST(Lighting, UnnegatedDirectionLightsTheWrongSide) {
    Spot spot;
    spot.technique.direction = DirectionSign::unnegated_diffuse;
    spot.light().type = LightType::directional;
    spot.light().direction = {0, -1, 0};
    EXPECT_EQ(spot.terms().diffuse.x, 0);
    EXPECT_NEAR(spot.terms().specular.x, 0.75, tight); // the highlight stays where it was
    spot.light().direction = {0, 1, 0};
    EXPECT_NEAR(spot.terms().diffuse.x, 0.5, tight);
    spot.light() = test::point_light({0, 2, 0});
    EXPECT_NEAR(spot.terms().diffuse.x, 1, tight);
}

TEST(Lighting, LightsSwitchedOffAreAbsent) {
    Spot spot;
    spot.scene.lights.push_back(test::point_light({1, 1, 1}));
    spot.light().enabled = false;
    const auto setup = prepare(spot.scene, spot.technique);
    ASSERT_EQ(setup.lights.size(), 1U);
    EXPECT_EQ(setup.light_index[0], 1U);
}

TEST(Lighting, BaseTintsTheBodyAndTheHighlightIfAsked) {
    Material material;
    material.emission = {0.1, 0, 0};
    const Reflected light{glm::dvec3(0.5), glm::dvec3(0.25)};
    EXPECT_EQ(compose(material, {0.5, 1, 0}, light), glm::dvec3(0.1 + 0.25 + 0.125, 0.75, 0));
    material.texture_modulates_specular = false;
    EXPECT_EQ(compose(material, {0.5, 1, 0}, light), glm::dvec3(0.1 + 0.25 + 0.25, 0.75, 0.25));
}

} // namespace
} // namespace sandbox::reference
