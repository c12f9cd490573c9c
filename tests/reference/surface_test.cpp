#include "reference/surface.h"

#include "scene/space.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

namespace sandbox::reference {
namespace {

constexpr double tight = 1e-14;

TEST(Normals, InverseTransposeIsTheGradientOfASquashedSphere) {
    // (x/2)^2 + (y/0.5)^2 + z^2 = 1: at the image of n the gradient is (n.x/2, n.y/0.5, n.z).
    Transform squash;
    squash.scale = {2, 0.5, 1};
    const glm::dmat3 matrix = normal_matrix(linear_part(squash), Normals::inverse_transpose);
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, 3));
    const glm::dvec3 expected = glm::normalize(glm::dvec3(n.x / 2, n.y / 0.5, n.z));
    EXPECT_NEAR(glm::length(transform_normal(matrix, n) - expected), 0, tight);
    const glm::dvec3 wrong = glm::normalize(glm::dvec3(n.x * 2, n.y * 0.5, n.z));
    EXPECT_NEAR(glm::length(transform_normal(normal_matrix(linear_part(squash), Normals::model_matrix), n) - wrong), 0,
                tight);
    EXPECT_EQ(transform_normal(normal_matrix(linear_part(squash), Normals::untransformed), n), n);
}

TEST(Normals, FaultsForgetTheSignTheLengthOrTheSpace) {
    Scene scene;
    scene.camera.position = {5, 0, 0}; // looks along -x: the world's x is the view's z
    scene.camera.target = {0, 0, 0};
    Transform transform;
    transform.scale = {-2, 3, 4};
    const auto normal = [&](Normals normals, const glm::dvec3 &n) {
        return world_transform(transform, prepare(scene, {.normals = normals})).normal(n);
    };
    EXPECT_EQ(normal(Normals::cofactor, {0, 1, 0}), glm::dvec3(0, -1, 0)); // det < 0
    EXPECT_EQ(normal(Normals::unnormalized, {0, 1, 0}), glm::dvec3(0, 3, 0));
    EXPECT_NEAR(glm::length(normal(Normals::view_space, {-1, 0, 0}) - glm::dvec3(0, 0, 1)), 0, tight);
    transform.scale = {2, 3, 4};
    EXPECT_EQ(normal(Normals::cofactor, {0, 1, 0}), glm::dvec3(0, 1, 0));
}

TEST(WorldTransform, AbsolutePositionsAreThoseOfFloat32) {
    Scene scene;
    scene.camera.position = {(1 << 24) + 1, 0, 0}; // float32 counts by twos from here on
    Transform transform;
    transform.translate = {1 << 24, 0.1, 0};
    const auto setup = prepare(scene, {.position = LightingPosition::absolute});
    const WorldTransform to_world = world_transform(transform, setup);
    EXPECT_EQ(to_world.lit({0.9, 0, 0}), glm::dvec3(0, double{0.1F}, 0)); // both round to 2^24
    EXPECT_EQ(to_world.seen({0.9, 0, 0}).y, 0.1);
    EXPECT_NEAR(to_world.seen({0.9, 0, 0}).x, -0.1, 1e-8); // double's own step there is 4e-9
}

TEST(Normals, MirroredObjectsKeepTheirNormalsOutside) {
    Transform mirror;
    mirror.scale = {-1, 1, 1};
    const glm::dmat3 matrix = normal_matrix(linear_part(mirror), Normals::inverse_transpose);
    EXPECT_EQ(transform_normal(matrix, {1, 0, 0}), glm::dvec3(-1, 0, 0));
    EXPECT_EQ(transform_normal(matrix, {0, 1, 0}), glm::dvec3(0, 1, 0));
}

TEST(Normals, AgreeWithTheInverseTransposeWhereThereIsOne) {
    Transform t;
    t.scale = {3, 1e-3, -20};
    t.rotate_degrees = {20, 50, -70};
    const glm::dmat3 linear = linear_part(t);
    const glm::dvec3 n = glm::normalize(glm::dvec3(-1, 2, 0.3));
    const glm::dvec3 expected = glm::normalize(glm::transpose(glm::inverse(linear)) * n);
    EXPECT_NEAR(glm::length(transform_normal(normal_matrix(linear, Normals::inverse_transpose), n) - expected), 0,
                1e-12);
}

TEST(Normals, ExtremeAndSingularScalesStayFiniteAndUnit) {
    for (const glm::dvec3 scale : {glm::dvec3(1, 0, 1), glm::dvec3(0, 0, 1), glm::dvec3(0), glm::dvec3(1, 1e-6, 1),
                                   glm::dvec3(1e13), glm::dvec3(1e-13), glm::dvec3(1e15, 1e-15, 1)}) {
        Transform t;
        t.scale = scale;
        t.rotate_degrees = {10, 20, 30};
        for (const Normals normals : {Normals::inverse_transpose, Normals::model_matrix, Normals::untransformed}) {
            const glm::dmat3 matrix = normal_matrix(linear_part(t), normals);
            for (const glm::dvec3 n : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0.6, 0.8)}) {
                EXPECT_NEAR(glm::length(transform_normal(matrix, n)), 1, tight);
            }
        }
    }
}

TEST(Normals, AFlatDiscFacesAlongItsAxis) {
    Transform t;
    t.scale = {1, 0, 1};
    const glm::dmat3 matrix = normal_matrix(linear_part(t), Normals::inverse_transpose);
    EXPECT_EQ(transform_normal(matrix, glm::normalize(glm::dvec3(3, 1, 2))), glm::dvec3(0, 1, 0));
    EXPECT_EQ(transform_normal(matrix, glm::normalize(glm::dvec3(3, -1, 2))), glm::dvec3(0, -1, 0));
}

/// Top row red green, bottom row blue white.
Image four_texels() {
    Image image({2, 2});
    image.pixels = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    return image;
}

TEST(Texture, CentresAndTheMeanOfFour) {
    const Image image = four_texels();
    EXPECT_EQ(sample_texture(image, {0.25, 0.75}), glm::dvec3(1, 0, 0)); // v grows upwards
    EXPECT_EQ(sample_texture(image, {0.25, 0.25}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(sample_texture(image, {0.5, 0.5}), glm::dvec3(0.5, 0.5, 0.5));
    EXPECT_EQ(sample_texture(image, {0.5, 0.75}), glm::dvec3(0.5, 0.5, 0));
}

TEST(Texture, Repeats) {
    const Image image = four_texels();
    EXPECT_EQ(sample_texture(image, {-0.75, 1.75}), glm::dvec3(1, 0, 0));
    EXPECT_EQ(sample_texture(image, {0, 0.75}), glm::dvec3(0.5, 0.5, 0)); // between the last texel and the first
    EXPECT_EQ(sample_texture(image, {1000000.25, -999999.25}), glm::dvec3(1, 0, 0));
}

TEST(CheckerColor, AlternatesInThreeAxesAndEndsAtTheCube) {
    Checker checker;
    checker.cells = 2;
    checker.colors = {glm::dvec3(0), glm::dvec3(1)};
    EXPECT_EQ(checker_color(checker, 1, {-0.5, -0.5, -0.5}), glm::dvec3(0));
    EXPECT_EQ(checker_color(checker, 1, {0.5, -0.5, -0.5}), glm::dvec3(1));
    EXPECT_EQ(checker_color(checker, 1, {0.5, 0.5, -0.5}), glm::dvec3(0));
    EXPECT_EQ(checker_color(checker, 1, {0.5, 0.5, 0.5}), glm::dvec3(1));
    EXPECT_EQ(checker_color(checker, 1, {1, 0.5, 0.5}), glm::dvec3(1));
    EXPECT_EQ(checker_color(checker, 0.7, {0, 0.1, 0.1}), glm::dvec3(1)); // the centre plane: exact for any extent
}

TEST(Checker, ACellEndsAtItsBordersAndNotAtTheCube) {
    const Checker checker{4, {glm::dvec3(0), glm::dvec3(1)}};
    BaseColor base;
    base.checker = &checker;
    const glm::dvec3 step(1e-3, 0, 0);
    const auto changes_at = [&](double x) {
        const glm::dvec3 here(x, 0.25, 0.25);
        return base.cell_may_change(here, here + step, here + step, glm::dvec3(0));
    };
    EXPECT_TRUE(changes_at(0.5));   // between the last two cells
    EXPECT_FALSE(changes_at(0.25)); // within a cell
    EXPECT_FALSE(changes_at(-1));   // the cube's own faces
    EXPECT_FALSE(changes_at(1));
}

} // namespace
} // namespace sandbox::reference
