#include "render/renderer.h"
#include "tools/gl_test.h"

#include <cmath>
#include <numbers>

namespace sandbox {
namespace {

/// The eye looks straight down on a plane, y = 0, from (0, 4, 0); the middle pixel of an odd picture sees the origin,
/// where N = V = (0, 1, 0).
Scene plane_from_above() {
    Scene scene;
    scene.camera.position = {0, 4, 0};
    scene.camera.up = {0, 0, -1};
    scene.objects = {{"plane", PlaneShape{{4, 4}, 2}, {}, {}, false}};
    return scene;
}

Light directional(double angle_degrees) {
    const double angle = angle_degrees * std::numbers::pi / 180;
    Light light;
    light.type = LightType::directional;
    light.direction = {-std::sin(angle), -std::cos(angle), 0};
    return light;
}

Light point_at(const glm::dvec3 &position) {
    Light light;
    light.position = position;
    return light;
}

Light spot_at(const glm::dvec3 &position, const glm::dvec3 &direction) {
    Light light = point_at(position);
    light.type = LightType::spot;
    light.direction = direction;
    return light;
}

class ClosedForm : public GlTest {
  protected:
    glm::vec3 middle(const Scene &scene, const std::string &technique) {
        return renderer_.render(scene, parse_technique(technique), {33, 33}).color.at(16, 16);
    }
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

// Float32 arithmetic of some twenty operations near 1: 2e-6. Powers multiply the cosine's error by n: 32 * 1e-7 = 3e-6.
constexpr float rounding = 4e-6F;

TEST_F(ClosedForm, LambertIsTheCosine) {
    Scene scene = plane_from_above();
    scene.lights = {directional(60)};
    scene.lights[0].color = {1, 0.5, 0.25};
    scene.lights[0].diffuse = 0.8;
    scene.objects[0].material.diffuse = {0.5, 1, 1};
    const glm::vec3 color = middle(scene, "per-pixel/lambert"); // cos 60 = 1/2
    EXPECT_NEAR(color.r, 0.2F, rounding);
    EXPECT_NEAR(color.g, 0.2F, rounding);
    EXPECT_NEAR(color.b, 0.1F, rounding);
}

TEST_F(ClosedForm, PhongIsThePowerOfTheMirroredAngle) {
    Scene scene = plane_from_above();
    scene.lights = {directional(30)}; // R.V = cos 30
    scene.lights[0].diffuse = 0;
    scene.lights[0].specular = 0.5;
    scene.objects[0].material.shininess = 32;
    EXPECT_NEAR(middle(scene, "per-pixel/phong").r, 0.5 * std::pow(std::cos(std::numbers::pi / 6), 32), rounding);
}

TEST_F(ClosedForm, BlinnPhongIsThePowerOfTheHalfAngle) {
    Scene scene = plane_from_above();
    scene.lights = {directional(30)}; // N.H = cos 15
    scene.lights[0].diffuse = 0;
    scene.objects[0].material.shininess = 8;
    scene.blinn_exponent_scale = 4; // n = 32
    EXPECT_NEAR(middle(scene, "per-pixel/blinn-phong").r, std::pow(std::cos(std::numbers::pi / 12), 32), rounding);
}

TEST_F(ClosedForm, ThePowersEnds) {
    Scene scene = plane_from_above();
    scene.lights = {directional(60)};
    scene.lights[0].diffuse = 0;
    scene.objects[0].material.shininess = 0;
    EXPECT_EQ(middle(scene, "per-pixel/phong").r, 1); // f^0 = 1
    scene.objects[0].material.shininess = 1;
    EXPECT_NEAR(middle(scene, "per-pixel/phong").r, 0.5F, rounding);
    scene.objects[0].material.shininess = 1e7;
    EXPECT_EQ(middle(scene, "per-pixel/phong").r, 0);
    scene.lights = {directional(0)};
    scene.lights[0].diffuse = 0;
    EXPECT_NEAR(middle(scene, "per-pixel/phong").r, 1, rounding); // head on: f = 1, at any n
}

TEST_F(ClosedForm, PointLightsFadeWithTheDistance) {
    Scene scene = plane_from_above();
    scene.lights = {point_at({0, 2, 0})};
    scene.lights[0].specular = 0;
    scene.lights[0].attenuation = {0.5, 0.25, 0.125}; // at d = 2: 1 / (0.5 + 0.5 + 0.5)
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 2.0 / 3, rounding);
    scene.lights[0].position = {std::sqrt(3), 1, 0}; // d = 2 again, at 60 degrees
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 1.0 / 3, rounding);
    scene.lights[0].attenuation = {0, 0, 0.25};
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 0.5, rounding);
}

TEST_F(ClosedForm, SpotsHaveAConeAnInnerConeAndAnExponent) {
    Scene scene = plane_from_above();
    const double angle = 20 * std::numbers::pi / 180; // between the axis and the way to the origin
    scene.lights = {spot_at({0, 2, 0}, {std::sin(angle), -std::cos(angle), 0})};
    Light &light = scene.lights[0];
    light.cutoff_degrees = light.inner_cutoff_degrees = 19;
    EXPECT_EQ(middle(scene, "per-pixel/lambert").r, 0);
    light.cutoff_degrees = light.inner_cutoff_degrees = 21;
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 1, rounding);
    light.exponent = 16;
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, std::pow(std::cos(angle), 16), rounding);
    light.exponent = 0;
    light.cutoff_degrees = 30;
    light.inner_cutoff_degrees = 10;
    const double outer = std::cos(30 * std::numbers::pi / 180);
    const double inner = std::cos(10 * std::numbers::pi / 180);
    const double t = (std::cos(angle) - outer) / (inner - outer);
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, t * t * (3 - 2 * t), 3e-5F); // the cosines' rounding over 0.12
    light.cutoff_degrees = light.inner_cutoff_degrees = 180;
    light.exponent = 50; // dropped with the cone
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 1, rounding);
}

TEST_F(ClosedForm, AmbientIsAttenuatedOnlyWhereAsked) {
    Scene scene = plane_from_above();
    scene.ambient = {0.125, 0, 0};
    scene.lights = {point_at({0, 2, 0})};
    Light &light = scene.lights[0];
    light.ambient = 0.25;
    light.diffuse = light.specular = 0;
    light.attenuation = {0, 0, 1}; // 1/4 at d = 2
    EXPECT_NEAR(middle(scene, "per-pixel/phong").r, 0.125 + 0.25, rounding);
    light.attenuate_ambient = true;
    EXPECT_NEAR(middle(scene, "per-pixel/phong").r, 0.125 + 0.0625, rounding);
    scene.objects[0].material.ambient = {2, 1, 1};
    scene.objects[0].material.emission = {1, 0, 0};
    EXPECT_NEAR(middle(scene, "per-pixel/phong").r, 1 + 2 * (0.125 + 0.0625), rounding);
}

TEST_F(ClosedForm, EveryFrequencyAgreesWhereTheEquationIsConstant) {
    Scene scene = plane_from_above();
    scene.lights = {directional(60)};
    scene.lights[0].ambient = 0.1;
    scene.lights[0].specular = 0;
    for (const char *frequency : {"flat", "per-vertex", "per-pixel", "interpolated-vectors", "hybrid"}) {
        EXPECT_NEAR(middle(scene, std::string(frequency) + "/phong").r, 0.6F, rounding) << frequency;
    }
}

TEST_F(ClosedForm, TheFaultsDoWhatTheySay) {
    Scene scene = plane_from_above();
    scene.lights = {directional(60)};
    scene.lights[0].specular = 0;
    EXPECT_EQ(middle(scene, "per-pixel/lambert:direction=unnegated-diffuse").r, 0);
    scene.lights[0].direction = {0, 1, 0}; // from below
    EXPECT_EQ(middle(scene, "per-pixel/lambert").r, 0);
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:direction=unnegated-diffuse").r, 1, rounding);
    scene.lights[0].ambient = 0.5;
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 0.5, rounding);
    EXPECT_EQ(middle(scene, "per-pixel/lambert:ambient=where-lit").r, 0);
    scene.lights[0] = directional(120); // below the horizon; R.V < 0, but N.H > 0
    scene.lights[0].diffuse = 0;
    scene.objects[0].material.shininess = 2;
    EXPECT_EQ(middle(scene, "per-pixel/blinn-phong").r, 0);
    EXPECT_NEAR(middle(scene, "per-pixel/blinn-phong:gate=none").r, 0.25, rounding); // cos^2 60
    EXPECT_NEAR(middle(scene, "per-pixel/blinn-phong:gate=view-facing").r, 0.25, rounding);
    scene = plane_from_above();
    scene.objects[0].transform.translate = {0, 1, 0};
    scene.lights = {point_at({0, 2, 0})};
    scene.lights[0].attenuation = {0, 1, 0};
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 1, rounding);               // d = 1
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:position=w0").r, 0.5, rounding); // lit as if at the origin: d = 2
}

TEST_F(ClosedForm, NormalsThatForgetASignALengthOrASpace) {
    Scene scene = plane_from_above();
    scene.lights = {directional(60)};
    scene.lights[0].specular = 0;
    scene.objects[0].transform.scale = {-1, 1, 1};
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, 0.5, rounding);
    EXPECT_EQ(middle(scene, "per-pixel/lambert:normals=cofactor").r, 0); // N points down
    scene.lights[0].direction = {0, 1, 0};                               // from below
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:normals=cofactor").r, 1, rounding);
    scene.lights = {directional(60)};
    scene.objects[0].material.shininess = 2;
    scene.camera.far_plane = 1000;
    for (const std::string frequency : {"flat", "per-vertex", "per-pixel", "interpolated-vectors", "hybrid"}) {
        scene.objects[0].transform.scale = glm::dvec3(0.5);
        scene.lights[0].specular = 0;
        EXPECT_NEAR(middle(scene, frequency + "/phong:normals=unnormalized").r, 0.25, rounding) << frequency;
        scene.lights[0].diffuse = 0;
        scene.lights[0].specular = 1;
        scene.objects[0].transform.scale = glm::dvec3(2);
        scene.objects[0].mesh = PlaneShape{{0.04, 0.04}, 1};
        scene.camera.position = {0, 200, 0};
        // N.H = 2 cos 30, squared, at every point to within 0.04 / 200
        EXPECT_NEAR(middle(scene, frequency + "/blinn-phong:normals=unnormalized").r, 3, 100 * rounding) << frequency;
        scene.objects[0].mesh = PlaneShape{{4, 4}, 2};
        scene.camera.position = {0, 4, 0};
        scene.lights[0].diffuse = 1;
    }
    scene.objects[0].transform.scale = glm::dvec3(1);
    scene.lights[0].specular = 0;
    scene.lights[0].direction = {0, 0, -1}; // along the floor; in view space N is (0, 0, 1)
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:normals=view-space").r, 1, rounding);
}

TEST_F(ClosedForm, NormalisedHighlightsAndLightPi) {
    Scene scene = plane_from_above();
    scene.lights = {directional(60)};
    scene.objects[0].material.shininess = 2;
    scene.blinn_exponent_scale = 4; // n = 8; N.H = cos 30
    const double pi = std::numbers::pi;
    EXPECT_NEAR(middle(scene, "per-pixel/blinn-phong:normalisation=blinn-phong").r,
                0.5 / pi + 16 / (8 * pi) * std::pow(0.75, 4), rounding);
    EXPECT_NEAR(middle(scene, "per-pixel/blinn-phong:gate=times-n-dot-l").r, 0.5 + 0.5 * std::pow(0.75, 4), rounding);
}

TEST_F(ClosedForm, NaivePowersAndUnitVectorsAreThoseOfTheTextbookWhereDefined) {
    Scene scene = plane_from_above();
    scene.lights = {directional(30), point_at({1, 2, 0}), spot_at({0, 2, 0}, {0, -1, 0})};
    scene.lights[2].cutoff_degrees = scene.lights[2].inner_cutoff_degrees = 60;
    for (const char *model : {"lambert", "phong", "blinn-phong"}) {
        const std::string technique = std::string("per-pixel/") + model;
        EXPECT_NEAR(middle(scene, technique + ":power=naive").r, middle(scene, technique).r, rounding) << model;
    }
}

TEST_F(ClosedForm, AbsolutePositionsLoseWhatFloat32CannotHold) {
    Scene scene = plane_from_above();
    scene.lights = {point_at({1, 1, 0})};
    scene.lights[0].specular = 0;
    scene.lights[0].attenuation = {0, 0, 1};
    const double right = std::sqrt(0.5) / 2;
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:position=absolute").r, right, rounding);
    const glm::dvec3 far{1 << 24, 0, 0}; // float32 counts by twos from here on
    scene.camera.position += far;
    scene.camera.target += far;
    scene.objects[0].transform.translate = far;
    scene.lights[0].position += far; // rounds to 0 off the middle in place of 1
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, right, rounding);
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:position=absolute").r, 1, rounding);
}

// At height y = 1/4 of a unit sphere squashed to half its height the object's normal is (cos 30, sin 30): the inverse
// transpose makes it (cos 30, 2 sin 30) / sqrt(7/4), the model matrix (cos 30, sin 30 / 2) / sqrt(13/16).
TEST_F(ClosedForm, NormalsOfASquashedSphere) {
    Scene scene = plane_from_above();
    scene.objects[0].mesh = SphereShape{1, 64, 128};
    scene.objects[0].transform.scale = {1, 0.5, 1};
    scene.camera.position = {8, 0.25, 0};
    scene.camera.target = {0, 0.25, 0};
    scene.camera.up = {0, 1, 0};
    scene.lights = {directional(0)};
    scene.lights[0].direction = {-1, 0, 0};
    constexpr float facets = 1e-3F; // normals interpolated over pi/64: (pi/64)^2 / 8 = 3e-4 of the angle's cosine
    const float cos_30 = std::sqrt(3.0F) / 2;
    EXPECT_NEAR(middle(scene, "per-pixel/lambert").r, cos_30 / std::sqrt(7.0F / 4), facets);
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:normals=model-matrix").r, cos_30 / std::sqrt(13.0F / 16), facets);
    EXPECT_NEAR(middle(scene, "per-pixel/lambert:normals=untransformed").r, cos_30, facets);
}

} // namespace
} // namespace sandbox
