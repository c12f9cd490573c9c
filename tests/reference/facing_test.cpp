#include "reference/reference_scenes.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

/// two_sided: N is turned where a triangle shows its back, and under facing=view where N.V < 0.
namespace sandbox {
namespace {

using test::render;

constexpr Size size{32, 24};

ReferenceFrame render_with(const Scene &scene, const Technique &technique, const std::shared_ptr<const Mesh> &mesh) {
    return render_reference(scene, {{mesh, nullptr}}, technique, size);
}

std::vector<Technique> every_frequency(Model model, Facing facing = Facing::winding) {
    std::vector<Technique> all;
    for (const Frequency frequency : all_frequencies) {
        all.push_back({.frequency = frequency, .model = model, .facing = facing});
    }
    return all;
}

glm::dvec3 middle_of(const ReferenceFrame &frame) {
    return frame.color[static_cast<std::size_t>(size.height / 2 * size.width + size.width / 2)];
}

/// A ball so coarse that interpolated normals lean away from the viewer along its outline.
Scene coarse_ball(bool two_sided) {
    Scene scene = test::ball({3, 1, -2}, 6);
    scene.lights[0].ambient = 0.15;
    scene.objects[0].two_sided = two_sided;
    return scene;
}

TEST(Facing, AClosedBallIsTheSameTwoSided) {
    for (const Model model : all_models) {
        for (const Technique &technique : every_frequency(model)) {
            EXPECT_EQ(render(coarse_ball(true), technique, size).color,
                      render(coarse_ball(false), technique, size).color)
                << to_string(technique);
        }
    }
    EXPECT_EQ(render(coarse_ball(true), {}, size, Surface::analytic).color,
              render(coarse_ball(false), {}, size, Surface::analytic).color);
}

TEST(Facing, WhereNDotVTurnsThePixelsAreThoseWhoseNormalLeansAway) {
    Scene scene = coarse_ball(true);
    scene.lights[0] = test::directional_light({0.25, 0.1, 1}); // from behind: it reaches what is turned
    constexpr Size size{160, 120};                             // the outline is a pixel wide
    const Technique view{.facing = Facing::view};
    const auto resources = test::resources_of(scene);
    const ReferenceFrame right = render(scene, {}, size);
    const ReferenceFrame fault = render(scene, view, size);
    int turned = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto pixel = static_cast<std::size_t>(y * size.width + x);
            if (right.object_ids[pixel] == 0) {
                continue;
            }
            const PixelProbe probe = *probe_pixel(scene, resources, {}, size, x, y);
            const bool leans_away = glm::dot(probe.normal, probe.view) < 0;
            turned += leans_away ? 1 : 0;
            const glm::dvec3 turns = probe_pixel(scene, resources, view, size, x, y)->normal;
            EXPECT_EQ(turns, leans_away ? -probe.normal : probe.normal) << x << ", " << y;
            if (!leans_away) {
                EXPECT_EQ(right.color[pixel], fault.color[pixel]) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(turned, 10);
    EXPECT_TRUE(right.color != fault.color);
}

/// The right value of the case, by hand: the light comes from behind, so the pixel has its ambient term alone.
TEST(Facing, TheCaseHasItsRightValue) {
    const Scene scene = open_scene(TEST_DATA_DIR "/lighting/two_sided_ball.json", Assets("assets"));
    const auto resources = test::resources_of(scene);
    const auto at = [&](const char *technique) {
        return probe_pixel(scene, resources, parse_technique(technique), {320, 240}, 231, 118)->color.x;
    };
    EXPECT_NEAR(at("per-pixel/blinn-phong"), 0.15, 1e-12);
    EXPECT_NEAR(at("per-pixel/blinn-phong:facing=view"), 1.352, 1e-3);
}

/// A square in the picture's plane, its front to the viewer or its back, under any transform: lit by a light on the
/// viewer's side as if it faced it (N.L = 1 in the middle), and by one on the other side not at all.
TEST(Facing, BothSidesOfASquareAreLitAsSeen) {
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.objects.push_back(test::object_of(PlaneShape{{2, 2}, 2}));
    scene.objects[0].two_sided = true;
    scene.lights.push_back(test::directional_light({0, 0, -1}));
    for (const double turn : {90.0, -90.0}) {
        for (const glm::dvec3 scale : {glm::dvec3(1), glm::dvec3(-1, 1, 1), glm::dvec3(1, -1, 1), glm::dvec3(1, 0, 1),
                                       glm::dvec3(-1, 0, 1), glm::dvec3(-1, -2, 0.5)}) {
            scene.objects[0].transform.rotate_degrees = {turn, 0, 0};
            scene.objects[0].transform.scale = scale;
            for (const Technique &technique : every_frequency(Model::lambert)) {
                for (const bool facing_light : {true, false}) {
                    scene.lights[0].direction = {0, 0, facing_light ? -1 : 1};
                    EXPECT_NEAR(middle_of(render(scene, technique, size)).x, facing_light ? 1 : 0, 1e-12)
                        << to_string(technique) << ", turned by " << turn << ", scale " << scale.x << " " << scale.y;
                }
            }
        }
    }
}

/// The wall of an open pipe, seen from above its rim: its outside and its inside both face the viewer where they show.
TEST(Facing, TheSideThatARayMeetsIsTheMeshs) {
    Scene scene;
    scene.camera.position = {0, 2.5, 3};
    CylinderShape pipe{0.8, 1.2, 512, 1};
    pipe.caps = false;
    scene.objects.push_back(test::object_of(pipe));
    scene.objects[0].two_sided = true;
    scene.objects[0].transform.scale = {-1, 1, 1};
    scene.lights.push_back(test::point_light({0.5, 3, 4}));
    const ReferenceFrame mesh = render(scene, {}, size);
    const ReferenceFrame analytic = render(scene, {}, size, Surface::analytic);
    int compared = 0;
    for (std::size_t i = 0; i < mesh.color.size(); ++i) {
        if (mesh.object_ids[i] != 0 && analytic.object_ids[i] != 0 && analytic.edge[i] == 0) {
            ++compared;
            EXPECT_NEAR(mesh.color[i].x, analytic.color[i].x, 1e-2)
                << i; // 512 slices: 0.7 degrees, stretched highlights
        }
    }
    EXPECT_GT(compared, 150);
}

/// Corners that run clockwise, with normals that face the viewer: the winding shows its back, so N points away.
TEST(Facing, AMeshThatRunsAgainstItsNormalsIsLitFromBehindAndSaysSo) {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 2, 1}};
    summarise(mesh);
    EXPECT_EQ(mesh.against_normals, 1U);
    EXPECT_NE(winding_note(mesh.against_normals, mesh.triangles.size()).find("1 of 1 triangles run clockwise"),
              std::string::npos);
    EXPECT_EQ(build_mesh(SphereShape{}).against_normals, 0U);
    EXPECT_EQ(winding_note(0, 12), "");
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.objects.push_back(test::object_of(ObjShape{"memory"}));
    scene.objects[0].two_sided = true;
    scene.lights.push_back(test::directional_light({0, 0, -1}));
    const auto shared = std::make_shared<const Mesh>(mesh);
    for (const Technique &technique : every_frequency(Model::lambert)) {
        EXPECT_EQ(middle_of(render_with(scene, technique, shared)).x, 0) << to_string(technique);
    }
    for (const Technique &technique : every_frequency(Model::lambert, Facing::view)) {
        EXPECT_NEAR(middle_of(render_with(scene, technique, shared)).x, 1, 1e-12) << to_string(technique);
    }
}

} // namespace
} // namespace sandbox
