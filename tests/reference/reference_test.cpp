#include "reference/reference.h"

#include "image/error.h"
#include "reference/reference_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

using test::ball;
using test::render;
using test::resources_of;

Technique technique_of(Frequency frequency, Model model) {
    Technique technique;
    technique.frequency = frequency;
    technique.model = model;
    return technique;
}

std::size_t centre_of(Size size) {
    return static_cast<std::size_t>(size.height / 2) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(size.width / 2);
}

TEST(Reference, SphereLitHeadOnIsFullAtItsMiddle) {
    Scene scene = ball({0, 0, 4});
    scene.lights[0].attenuation = {0.25, 0.125, 0.0625};
    scene.lights[0].ambient = 0.1;
    scene.ambient = {0.2, 0, 0};
    scene.objects[0].material.emission = {0, 0, 0.5};
    const Size size{33, 33};
    const ReferenceFrame frame = render(scene, {}, size, Surface::analytic);
    // d = 3: a = 1 / (0.25 + 0.375 + 0.5625); ambient is not attenuated; N.L = N.H = 1.
    const double a = 1 / 1.1875;
    const glm::dvec3 middle = frame.color[centre_of(size)];
    EXPECT_NEAR(middle.x, 0.2 + 0.1 + 2 * a, 1e-13);
    EXPECT_NEAR(middle.y, 0.1 + 2 * a, 1e-13);
    EXPECT_NEAR(middle.z, 0.5 + 0.1 + 2 * a, 1e-13);
    EXPECT_EQ(frame.object_ids[centre_of(size)], 1U);
    EXPECT_EQ(frame.object_ids[0], 0U);
}

TEST(Reference, TheColoursAloneAreTheSame) {
    Scene scene = ball({0, 0, 4});
    scene.background = {0.1, 0.2, 0.3};
    const Size size{64, 48};
    for (const Frequency frequency : all_frequencies) {
        const Technique technique = technique_of(frequency, Model::phong);
        EXPECT_EQ(reference_colors(scene, resources_of(scene), technique, size).pixels,
                  to_frame(render(scene, technique, size, Surface::mesh)).color.pixels);
    }
}

TEST(Reference, PlaneUnderAPointLight) {
    Scene scene;
    scene.camera.position = {0, 3, 0};
    scene.camera.up = {0, 0, -1};
    scene.objects.push_back(test::object_of(PlaneShape{{4, 4}, 1}));
    scene.lights.push_back(test::point_light({0, 2, 0}));
    scene.lights[0].attenuation = {0, 0, 1};
    const Size size{41, 31};
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame frame = render(scene, technique_of(Frequency::per_pixel, Model::lambert), size, surface);
        for (int y = 3; y < 28; y += 4) {
            for (int x = 3; x < 38; x += 5) {
                // Straight down, pixel (x, y) sees the ground at these offsets from the middle.
                const double scale = 3 * std::tan(22.5 * std::acos(-1.0) / 180) / 15.5;
                const double right = (x - 20) * scale;
                const double down = (y - 15) * scale;
                const double square = right * right + down * down + 4;
                // cos / d^2 = 2 / d^3
                const double expected = 2 / (square * std::sqrt(square));
                const auto pixel = static_cast<std::size_t>(y * size.width + x);
                EXPECT_NEAR(frame.color[pixel].x, expected, 1e-14) << x << ' ' << y;
            }
        }
    }
}

/// L2 error of a ball's mesh against the shape, in the middle of its disc: at the outline the mesh ends too soon, and
/// at the terminator the light has a kink; both converge more slowly.
std::vector<double> errors_of_tessellations(const Technique &technique, const glm::dvec3 &light) {
    const Size size{200, 200};
    const ReferenceFrame exact =
        render(ball(light), technique_of(Frequency::per_pixel, technique.model), size, Surface::analytic);
    std::vector<double> errors;
    for (const int rings : {16, 32, 64, 128}) {
        const ReferenceFrame mesh = render(ball(light, rings), technique, size);
        double sum = 0;
        int count = 0;
        for (int i = 0; i < size.width * size.height; ++i) {
            // The ball's radius is 62 pixels.
            if (std::hypot(i % size.width - 99.5, i / size.width - 99.5) < 40) {
                const auto pixel = static_cast<std::size_t>(i);
                sum += std::pow(mesh.color[pixel].x - exact.color[pixel].x, 2);
                ++count;
            }
        }
        errors.push_back(std::sqrt(sum / count));
    }
    return errors;
}

/// Linear interpolation of a smooth function errs by h^2, and so does the triangle's own place. 0.1: the pixels sample
/// triangles that are but a few pixels wide.
void expect_order_two(const std::vector<double> &errors) {
    for (std::size_t i = 1; i < errors.size(); ++i) {
        EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), 2, 0.1) << i;
    }
}

TEST(Reference, PerVertexLambertConvergesAtOrderTwo) {
    expect_order_two(errors_of_tessellations(technique_of(Frequency::per_vertex, Model::lambert), {2, 3, 9}));
}

TEST(Reference, PerPixelOnMeshesConvergesToTheShapeAtOrderTwo) {
    const std::vector<double> errors =
        errors_of_tessellations(technique_of(Frequency::per_pixel, Model::lambert), {2, 3, 9});
    expect_order_two(errors);
    EXPECT_LT(errors.back(), 1e-4);
}

TEST(Reference, PerVertexIsExactAtAVertex) {
    // Odd size, an even sphere: the middle pixel sees the vertex at (0, 0, 1).
    const Scene scene = ball({3, 1, 4}, 16);
    const Size size{31, 31};
    for (const Model model : {Model::lambert, Model::phong, Model::blinn_phong}) {
        const ReferenceFrame exact = render(scene, technique_of(Frequency::per_pixel, model), size, Surface::analytic);
        for (const Frequency frequency :
             {Frequency::per_vertex, Frequency::per_pixel, Frequency::interpolated_vectors, Frequency::hybrid}) {
            const ReferenceFrame mesh = render(scene, technique_of(frequency, model), size);
            const glm::dvec3 d = mesh.color[centre_of(size)] - exact.color[centre_of(size)];
            EXPECT_NEAR(glm::length(d), 0, 1e-12) << static_cast<int>(frequency);
            EXPECT_EQ(mesh.edge[centre_of(size)], 1);
        }
    }
}

TEST(Reference, FlatIsTheFaceAtItsCentroid) {
    Scene scene;
    scene.camera.position = {0, 0, 5};
    scene.objects.push_back(test::object_of(BoxShape{{2, 2, 2}, 1}));
    scene.lights.push_back(test::point_light({0, 0, 4}));
    scene.lights[0].diffuse = 1;
    const Size size{40, 40};
    const ReferenceFrame frame = render(scene, technique_of(Frequency::flat, Model::lambert), size);
    // Both triangles of the front face have centroids (+-1/3, -+1/3, 1): N.L = 3 / sqrt(9 + 2/9).
    EXPECT_NEAR(frame.color[centre_of(size) + 4].x, 3 / std::sqrt(9 + 2.0 / 9), 1e-14);
    EXPECT_EQ(frame.color[centre_of(size) + 4], frame.color[centre_of(size) + 5]);
}

TEST(Reference, HybridSplitsTheTermsBetweenTheStages) {
    Scene scene = ball({2, 2, 4}, 12);
    const Size size{48, 48};
    const ReferenceFrame hybrid = render(scene, technique_of(Frequency::hybrid, Model::phong), size);
    const ReferenceFrame body = render(scene, technique_of(Frequency::per_vertex, Model::lambert), size);
    const ReferenceFrame pixel = render(scene, technique_of(Frequency::per_pixel, Model::phong), size);
    const ReferenceFrame pixel_body = render(scene, technique_of(Frequency::per_pixel, Model::lambert), size);
    for (std::size_t i = 0; i < hybrid.color.size(); ++i) {
        const glm::dvec3 expected = body.color[i] + pixel.color[i] - pixel_body.color[i];
        EXPECT_NEAR(glm::length(hybrid.color[i] - expected), 0, 1e-13);
    }
}

TEST(Reference, InterpolatedAttenuationIsTheCornersMean) {
    // A plane of two triangles: at the middle of the diagonal both corners are equally far and equally attenuated.
    Scene scene;
    scene.camera.position = {0, 3, 0};
    scene.camera.up = {0, 0, -1};
    scene.objects.push_back(test::object_of(PlaneShape{{2, 2}, 1}));
    scene.lights.push_back(test::point_light({0, 1, 0}));
    scene.lights[0].attenuation = {1, 0, 1};
    Technique technique = technique_of(Frequency::per_pixel, Model::lambert);
    const Size size{21, 21};
    EXPECT_NEAR(render(scene, technique, size).color[centre_of(size)].x, 1 / 2.0, 1e-14); // 1 / (1 + 1)
    technique.attenuation = AttenuationAt::interpolated;
    EXPECT_NEAR(render(scene, technique, size).color[centre_of(size)].x, 1 / 4.0, 1e-14); // d^2 = 3 at the corners
    technique.attenuation = AttenuationAt::distance_interpolated;
    EXPECT_NEAR(render(scene, technique, size).color[centre_of(size)].x, 1 / 4.0, 1e-14);
    technique.frequency = Frequency::interpolated_vectors;
    technique.attenuation = AttenuationAt::exact;
    // L from the corners is (+-1, 1, +-1) / sqrt 3; their mean points straight up and is made unit again.
    EXPECT_NEAR(render(scene, technique, size).color[centre_of(size)].x, 1 / 4.0, 1e-14);
}

TEST(Reference, WithoutRenormalisingTheNormalStaysShort) {
    const Size size{64, 64};
    Scene scene = ball({0, 0, 4}, 4);
    Technique technique = technique_of(Frequency::per_pixel, Model::lambert);
    const ReferenceFrame right = render(scene, technique, size);
    technique.renormalize = Renormalize::off;
    const ReferenceFrame wrong = render(scene, technique, size);
    double largest = 0;
    for (std::size_t i = 0; i < right.color.size(); ++i) {
        EXPECT_LE(wrong.color[i].x, right.color[i].x + 1e-15);
        largest = std::max(largest, right.color[i].x - wrong.color[i].x);
    }
    EXPECT_GT(largest, 0.05);
}

TEST(Reference, DroppingTheTranslationLightsAsIfAtTheOrigin) {
    Scene scene = ball({0, 0, 2});
    scene.objects[0].transform.translate = {0, 0, -3};
    scene.lights[0].attenuation = {0, 0, 1};
    Technique technique = technique_of(Frequency::per_pixel, Model::lambert);
    const Size size{33, 33};
    EXPECT_NEAR(render(scene, technique, size, Surface::analytic).color[centre_of(size)].x, 1 / 16.0, 1e-13);
    technique.position = LightingPosition::w0;
    EXPECT_NEAR(render(scene, technique, size, Surface::analytic).color[centre_of(size)].x, 1, 1e-13);
    EXPECT_NEAR(render(scene, technique, size).color[centre_of(size)].x, 1, 1e-13);
}

TEST(Reference, TwoSidedTurnsTheNormalToTheViewer) {
    Scene scene;
    scene.camera.position = {0, -3, 0};
    scene.camera.up = {0, 0, -1};
    scene.objects.push_back(test::object_of(PlaneShape{}));
    scene.lights.push_back(test::point_light({0, -2, 0}));
    const Size size{15, 15};
    for (const Frequency frequency : {Frequency::flat, Frequency::per_vertex, Frequency::per_pixel}) {
        const Technique technique = technique_of(frequency, Model::lambert);
        scene.objects[0].two_sided = false;
        EXPECT_EQ(render(scene, technique, size).color[centre_of(size)].x, 0);
        scene.objects[0].two_sided = true;
        EXPECT_GT(render(scene, technique, size).color[centre_of(size)].x, 0.8);
    }
}

TEST(Reference, FarFromTheOriginNothingIsLost) {
    Scene near = ball({1, 2, 4});
    Scene far = near;
    const glm::dvec3 away(1e7, -1e7, 5e6);
    far.camera.position += away;
    far.camera.target += away;
    far.lights[0].position += away;
    far.objects[0].transform.translate += away;
    const Size size{40, 40};
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame a = render(near, {}, size, surface);
        const ReferenceFrame b = render(far, {}, size, surface);
        EXPECT_EQ(a.object_ids, b.object_ids);
        EXPECT_EQ(a.color, b.color);
    }
}

TEST(Reference, StiffAndExtremeScenesStayFinite) {
    const Size size{24, 24};
    std::vector<Scene> scenes;
    for (const glm::dvec3 scale : {glm::dvec3(1, 0, 1), glm::dvec3(0, 0, 1), glm::dvec3(0), glm::dvec3(-1, 1, 1),
                                   glm::dvec3(1, 1e-6, 1), glm::dvec3(1e13), glm::dvec3(1e-13)}) {
        scenes.push_back(ball({1, 2, 4}));
        scenes.back().objects[0].transform.scale = scale;
    }
    scenes.push_back(ball({0, 0, 0}));
    scenes.back().camera.position = {0.2, 0.1, 0.3}; // inside
    scenes.push_back(ball({0, 0, 1}));               // a light on a vertex
    scenes.push_back(ball({0, 0, 4}));
    scenes.back().camera = {{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, 45, 1e-6, 1e9}; // the eye on a vertex
    scenes.push_back(ball({0, 0, 4}));
    for (int i = 0; i < 63; ++i) {
        scenes.back().lights.push_back(test::point_light({i, 63 - i, 4}));
        scenes.back().lights.back().diffuse = 1e6;
    }
    for (Scene &scene : scenes) {
        for (const double n : {0.0, 1e7}) {
            scene.objects[0].material.shininess = n;
            for (const Frequency frequency : {Frequency::flat, Frequency::per_vertex, Frequency::per_pixel,
                                              Frequency::interpolated_vectors, Frequency::hybrid}) {
                for (const Model model : {Model::phong, Model::blinn_phong}) {
                    EXPECT_TRUE(test::all_finite(render(scene, technique_of(frequency, model), size)));
                }
            }
        }
    }
}

TEST(Reference, AProbeExplainsItsPixel) {
    Scene scene = ball({1, 2, 4});
    scene.lights.push_back(test::directional_light({0, -1, -1}));
    scene.lights.push_back(test::point_light({0, 0, 0}));
    scene.lights[2].enabled = false;
    scene.ambient = {0.1, 0.1, 0.1};
    const Size size{40, 30};
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame frame = render(scene, {}, size, surface);
        const auto probe = probe_pixel(scene, resources_of(scene), {}, size, 22, 13, surface);
        ASSERT_TRUE(probe.has_value());
        EXPECT_EQ(probe->color, frame.color[13 * 40 + 22]);
        ASSERT_EQ(probe->lights.size(), 2U);
        glm::dvec3 sum = scene.ambient;
        for (const reference::LightProbe &light : probe->lights) {
            sum += light.terms.ambient + light.terms.diffuse + light.terms.specular;
        }
        EXPECT_NEAR(glm::length(sum - probe->color), 0, 1e-14);
        EXPECT_NEAR(glm::length(probe->position), 1, 0.01);
        EXPECT_FALSE(probe_pixel(scene, resources_of(scene), {}, size, 0, 0, surface).has_value());
    }
}

/// Four roundings of 2^-24 of the width, times the slope of the colour: that between the neighbours, to a per cent.
TEST(Reference, WindowRoundingIsTheSlopeOfTheColour) {
    Scene scene = ball({1, 2, 2});
    scene.objects = {test::object_of(PlaneShape{{8, 8}, 1})};
    scene.objects[0].transform.rotate_degrees = {90, 0, 0};
    const Size size{64, 48};
    const int x = 40;
    const int y = 11;
    const ReferenceFrame frame = render(scene, {}, size);
    const auto red = [&](int column, int row) { return frame.color[static_cast<std::size_t>(row * 64 + column)].r; };
    const double slope = std::abs(red(x + 1, y) - red(x - 1, y)) / 2 + std::abs(red(x, y + 1) - red(x, y - 1)) / 2;
    const auto probe = probe_pixel(scene, resources_of(scene), {}, size, x, y);
    EXPECT_GT(slope, 1e-3);
    EXPECT_NEAR(probe->window_rounding, slope * 4 * 0x1p-24 * 64, 0.01 * slope * 0x1p-22 * 64);
    scene.lights.clear();
    EXPECT_EQ(probe_pixel(scene, resources_of(scene), {}, size, x, y)->window_rounding, 0);
}

TEST(Reference, WhatHasNoAnalyticSurfaceIsRefused) {
    Scene scene = ball({0, 0, 4});
    const Technique per_vertex = technique_of(Frequency::per_vertex, Model::phong);
    EXPECT_THROW(render(scene, per_vertex, {4, 4}, Surface::analytic), InputError);
    scene.objects[0].transform.scale.y = 0;
    EXPECT_THROW(render(scene, {}, {4, 4}, Surface::analytic), InputError);
    scene.objects[0].transform.scale.y = 1;
    const std::vector<ObjectResources> resources = resources_of(scene);
    scene.objects[0].mesh = ObjShape{"/tmp/a.obj"};
    EXPECT_THROW(render_reference(scene, resources, {}, {4, 4}, Surface::analytic), InputError);
}

TEST(Reference, ProgressIsToldAndCanStop) {
    const Scene scene = ball({0, 0, 4});
    double last = 0;
    render_reference(scene, resources_of(scene), {}, {64, 64}, Surface::mesh, [&](double share) {
        EXPECT_GE(share, last);
        last = share;
        return true;
    });
    EXPECT_EQ(last, 1);
    EXPECT_THROW(
        render_reference(scene, resources_of(scene), {}, {64, 64}, Surface::mesh, [](double) { return false; }),
        Cancelled);
}

TEST(Reference, TheSameBitsEveryTime) {
    const Scene scene = ball({1, 2, 4});
    const ReferenceFrame a = render(scene, {}, {100, 80});
    const ReferenceFrame b = render(scene, {}, {100, 80});
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.edge, b.edge);
    EXPECT_EQ(a.jump, b.jump);
}

} // namespace
} // namespace sandbox
