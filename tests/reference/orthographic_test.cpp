#include "reference/reference_scenes.h"
#include "scene/orbit.h"
#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

/// The orthographic camera in the truth: closed forms, in triangles and without.
namespace sandbox {
namespace {

using test::render;

Camera looking_down_z(double height, double distance = 5) {
    Camera camera{.position = {0, 0, distance}, .near_plane = 0.5, .far_plane = distance + 10};
    camera.projection = Projection::orthographic;
    camera.height = height;
    return camera;
}

std::size_t pixel_at(Size size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
}

/// A unit sphere in a picture 4 high and 200 pixels: its outline has a radius of 50 pixels from any distance. A pixel
/// shows it where its centre is nearer than that.
TEST(Orthographic, ASpheresOutlineIsACircleOfThatManyPixels) {
    const Size size{240, 200};
    for (const double distance : {3.0, 40.0, 1e6}) {
        Scene scene = test::ball({0, 0, 4});
        scene.camera = looking_down_z(4, distance);
        const ReferenceFrame frame = render(scene, {}, size, Surface::analytic);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const bool inside = std::hypot(x + 0.5 - 120, y + 0.5 - 100) < 50;
                ASSERT_EQ(frame.object_ids[pixel_at(size, x, y)] != 0, inside) << distance << ": " << x << ", " << y;
            }
        }
    }
    Scene scene = test::ball({0, 0, 4}, 256);
    scene.camera = looking_down_z(4);
    const ReferenceFrame mesh = render(scene, {}, size);
    const auto shown = std::ranges::count_if(mesh.object_ids, [](std::uint32_t id) { return id != 0; });
    EXPECT_NEAR(static_cast<double>(shown), std::numbers::pi * 50 * 50, 20);
}

/// V is the same everywhere: a directional light's highlight fills a plane evenly, here with N.H = cos 15 degrees.
TEST(Orthographic, VIsTheViewAxisAtEveryPoint) {
    Scene scene;
    scene.camera = looking_down_z(4);
    scene.objects = {test::object_of(PlaneShape{{8, 8}, 3})};
    scene.objects[0].transform.rotate_degrees = {90, 0, 0};
    scene.objects[0].material.shininess = 20;
    scene.lights = {test::directional_light({-std::sin(std::numbers::pi / 6), 0, -std::cos(std::numbers::pi / 6)})};
    const double cosine = std::cos(std::numbers::pi / 12);
    const double mirrored = std::cos(std::numbers::pi / 6);
    const Size size{12, 8};
    for (const Frequency frequency : all_frequencies) {
        for (const Model model : {Model::phong, Model::blinn_phong}) {
            const Technique technique{.frequency = frequency, .model = model};
            const double f = model == Model::phong ? mirrored : cosine;
            for (const glm::dvec3 &color : render(scene, technique, size).color) {
                EXPECT_NEAR(color.x, mirrored + std::pow(f, 20), 1e-12) << to_string(technique);
            }
        }
    }
    const auto probe = probe_pixel(scene, test::resources_of(scene), {}, size, 1, 7, Surface::analytic);
    EXPECT_EQ(probe->view, glm::dvec3(0, 0, 1));
}

TEST(Orthographic, AnInfiniteViewerIsTheSamePicture) {
    Scene scene = test::ball({1, 2, 3});
    scene.camera = with_projection(scene.camera, Projection::orthographic);
    for (const Frequency frequency : all_frequencies) {
        Technique technique{.frequency = frequency};
        const auto local = render(scene, technique, {32, 24}).color;
        technique.viewer = Viewer::infinite;
        EXPECT_EQ(render(scene, technique, {32, 24}).color, local) << to_string(technique);
    }
}

/// From a million away, a perspective picture of the same height differs by what an angle of 1e-6 does.
TEST(Orthographic, IsTheLimitOfAFarPerspective) {
    Scene scene = test::ball({1, 2, 3});
    scene.camera = looking_down_z(3, 1e6);
    scene.camera.near_plane = 1e5;
    Scene narrow = scene;
    narrow.camera = with_projection(scene.camera, Projection::perspective);
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame a = render(scene, {}, {60, 40}, surface);
        const ReferenceFrame b = render(narrow, {}, {60, 40}, surface);
        for (std::size_t i = 0; i < a.color.size(); ++i) {
            if (a.edge[i] == 0 && a.jump[i] == 0) {
                EXPECT_NEAR(a.color[i].x, b.color[i].x, 2e-4) << i;
            }
        }
    }
}

/// A plane that leans back by 45 degrees: its depth grows by as much as it rises, so near and far cut it at known rows.
TEST(Orthographic, NearAndFarCutAtTheirDistances) {
    Scene scene;
    scene.camera = looking_down_z(8);
    scene.camera.near_plane = 3.5; // y = -1.5 lies 3.5 before the eye, y = 2.5 lies 7.5
    scene.camera.far_plane = 7.5;
    scene.objects = {test::object_of(PlaneShape{{40, 40}, 1})};
    scene.objects[0].transform.rotate_degrees = {45, 0, 0};
    scene.lights = {test::directional_light({0, -1, -1})};
    const Size size{8, 80}; // ten rows a unit
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame frame = render(scene, {}, size, surface);
        for (int y = 0; y < size.height; ++y) {
            const double height = 4 - (y + 0.5) / 10;
            EXPECT_EQ(frame.object_ids[pixel_at(size, 4, y)] != 0, height > -1.5 && height < 2.5) << y;
        }
    }
}

TEST(Orthographic, TheNearerSurfaceHidesTheOther) {
    Scene scene;
    scene.camera = looking_down_z(2);
    scene.objects = {test::object_of(PlaneShape{{1, 1}, 1}), test::object_of(PlaneShape{{4, 4}, 2})};
    for (Object &object : scene.objects) {
        object.transform.rotate_degrees = {90, 0, 0};
    }
    scene.lights = {test::directional_light({0, 0, -1})};
    for (const double step : {1e-4, -1e-4}) { // of a depth range of 14.5: 7e-6, far above 4e-7
        scene.objects[0].transform.translate = {0, 0, step};
        const ReferenceFrame frame = render(scene, {}, {10, 10});
        EXPECT_EQ(frame.object_ids[pixel_at({10, 10}, 4, 3)], step > 0 ? 1U : 2U);
        EXPECT_EQ(frame.edge[pixel_at({10, 10}, 4, 3)], 0);
        EXPECT_EQ(frame.object_ids[pixel_at({10, 10}, 0, 0)], 2U);
    }
}

} // namespace
} // namespace sandbox
