#include "reference/reference.h"

#include "reference/branches.h"

#include "reference/reference_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

/// Which pixels are left out of error figures, and that no others are.
namespace sandbox {
namespace {

using test::ball;
using test::render;

Technique lambert() {
    Technique technique;
    technique.model = Model::lambert;
    return technique;
}

TEST(ReferenceMasks, StepsOfTheEquationAreMarked) {
    // A hard cone on a plane: the circle's pixels are marked, few others, and no pixel far from it.
    Scene scene = test::spot_over_a_plane();
    const Size size{401, 401};
    const double scale = 3 * std::tan(22.5 * std::acos(-1.0) / 180) / 200.5;
    const auto distance_to_circle = [&](int x, int y) {
        return std::abs(std::hypot(x - 200, y - 200) - std::tan(std::acos(-1.0) / 6) / scale);
    };
    const ReferenceFrame frame = render(scene, lambert(), size);
    int marked = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool jump = frame.jump[static_cast<std::size_t>(y * size.width + x)] != 0;
            marked += jump ? 1 : 0;
            if (distance_to_circle(x, y) < 1.0 / 128) {
                EXPECT_TRUE(jump) << x << ' ' << y;
            }
            if (distance_to_circle(x, y) > 2.0 / 128) {
                EXPECT_FALSE(jump) << x << ' ' << y;
            }
        }
    }
    EXPECT_GT(marked, 0);
    scene.lights[0].inner_cutoff_degrees = 20; // a soft edge does not jump
    const ReferenceFrame soft = render(scene, lambert(), size);
    EXPECT_EQ(std::count(soft.jump.begin(), soft.jump.end(), 1), 0);
}

std::ptrdiff_t jumps(const Scene &scene, const Technique &technique) {
    const ReferenceFrame frame = render(scene, technique, {101, 101});
    return std::count(frame.jump.begin(), frame.jump.end(), 1);
}

TEST(ReferenceMasks, EachBranchIsMarkedWhereItIsTaken) {
    Scene scene = ball({0, 0, 0});
    scene.lights[0] = test::directional_light({-1, 0, 0.1});
    scene.objects[0].material.shininess = 1;
    Technique technique;
    EXPECT_GT(jumps(scene, technique), 0); // the highlight ends at the terminator
    technique.gate = Gate::none;
    EXPECT_EQ(jumps(scene, technique), 0);
    technique.gate = Gate::times_n_dot_l; // fades instead
    EXPECT_EQ(jumps(scene, technique), 0);
    technique.ambient = AmbientWhere::where_lit;
    EXPECT_EQ(jumps(scene, technique), 0); // there is no ambient light
    scene.lights[0].ambient = 0.5;
    EXPECT_GT(jumps(scene, technique), 0);
    technique.ambient = AmbientWhere::everywhere;
    technique.gate = Gate::none;
    technique.model = Model::phong;
    scene.objects[0].material.shininess = 0.01; // leaves 0 like a jump where R.V = 0
    EXPECT_GT(jumps(scene, technique), 0);
}

TEST(ReferenceMasks, ALightWithinRoundingOfTheSurfaceHasNoDirection) {
    Scene scene;
    scene.camera.position = {0, 0, 10};
    scene.lights = {test::point_light({1, 0, 0})};
    const reference::Setup prepared = reference::prepare(scene, {});
    const glm::dvec3 light = scene.lights[0].position - scene.camera.position;
    // Positions of 10 are rounded to 2e-7 or so: less than a tenth of 1e-3, more than that of 1e-5.
    EXPECT_TRUE(reference::direction_is_rounding(prepared, prepared.lights[0], light + glm::dvec3(0, 1e-5, 0)));
    EXPECT_FALSE(reference::direction_is_rounding(prepared, prepared.lights[0], light + glm::dvec3(0, 1e-3, 0)));
}

TEST(ReferenceMasks, ACreaseOfAnAnalyticShapeIsAnEdge) {
    Scene scene;
    scene.camera.position = {0, 3, 3}; // sees a cylinder's cap and its side
    scene.objects = {test::object_of(CylinderShape{1, 1, 32, 1})};
    scene.lights = {test::point_light({2, 3, 4})};
    const ReferenceFrame frame = render(scene, lambert(), {601, 601}, Surface::analytic);
    int inner = 0; // edges with the object all around
    for (std::size_t y = 2; y < 599; ++y) {
        for (std::size_t x = 2; x < 599; ++x) {
            const std::size_t i = y * 601 + x;
            const bool inside = frame.object_ids[i] == 1 && frame.object_ids[i - 2] == 1 &&
                                frame.object_ids[i + 2] == 1 && frame.object_ids[i - 2 * 601] == 1 &&
                                frame.object_ids[i + 2 * 601] == 1;
            inner += inside && frame.edge[i] != 0 ? 1 : 0;
        }
    }
    EXPECT_GT(inner, 0);
}

TEST(ReferenceMasks, TheGateIsMarkedOnlyWhereAHighlightReachesIt) {
    // The terminator of a ball lit from the side; a wide highlight (n = 1) crosses it, a narrow one does not.
    Scene scene = ball({0, 0, 0});
    scene.lights[0] = test::directional_light({-1, 0, 0.1});
    const Size size{301, 301};
    scene.objects[0].material.shininess = 1;
    const ReferenceFrame wide = render(scene, {}, size, Surface::analytic);
    EXPECT_GT(std::count(wide.jump.begin(), wide.jump.end(), 1), 0);
    EXPECT_LT(std::count(wide.jump.begin(), wide.jump.end(), 1), 40);
    scene.objects[0].material.shininess = 200;
    const ReferenceFrame narrow = render(scene, {}, size, Surface::analytic);
    EXPECT_EQ(std::count(narrow.jump.begin(), narrow.jump.end(), 1), 0);
}

TEST(ReferenceMasks, AnExactGrazingLightIsNotInDoubt) {
    // N.L = 0 exactly all over the floor, in any precision; turned by 30 degrees about another axis it is a rounding.
    Scene scene;
    scene.objects.push_back(test::object_of(PlaneShape{{4, 4}, 2}));
    scene.objects[0].material.shininess = 1;
    scene.lights.push_back(test::directional_light({-1, 0, -1}));
    const Size size{40, 40};
    const ReferenceFrame exact = render(scene, {}, size);
    EXPECT_EQ(std::count(exact.jump.begin(), exact.jump.end(), 1), 0);
    scene.objects[0].transform.rotate_degrees = {0, 0, 30};
    scene.lights[0].direction = {-std::sqrt(0.75), -0.5, 0};
    const ReferenceFrame rounded = render(scene, {}, size);
    EXPECT_EQ(std::count(rounded.jump.begin(), rounded.jump.end(), 1),
              std::count(rounded.object_ids.begin(), rounded.object_ids.end(), 1U));
}

TEST(ReferenceMasks, CheckerBoundariesAreMarked) {
    Scene scene = ball({0, 0, 4});
    scene.objects[0].material.checker = Checker{};
    const Size size{201, 201};
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame frame = render(scene, {}, size, surface);
        // The middle row and column look along the planes y = 0 and x = 0, which are cell boundaries.
        EXPECT_EQ(frame.jump[static_cast<std::size_t>(100 * 201 + 110)], 1);
        EXPECT_EQ(frame.jump[static_cast<std::size_t>(110 * 201 + 100)], 1);
        const auto share = static_cast<double>(std::count(frame.jump.begin(), frame.jump.end(), 1)) /
                           static_cast<double>(frame.jump.size());
        EXPECT_LT(share, 0.02);
    }
}

TEST(ReferenceMasks, EdgesOfTrianglesAndOutlines) {
    // A front face of two triangles, 1 pixel for each 1/8 unit: diagonal and outline pass through pixel centres.
    Scene scene;
    scene.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 2 * std::atan(0.25) * 180 / std::acos(-1.0), 0.1, 100};
    scene.objects.push_back(test::object_of(BoxShape{{1, 1, 4}, 1}));
    const Size size{33, 33};
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame frame = render(scene, {}, size, surface);
        // The front face, 8 away, spans 33 * 1 / 4 = 8.25 pixels about the middle: no outline through a centre.
        EXPECT_EQ(frame.object_ids[16 * 33 + 20], 1U);
        EXPECT_EQ(frame.object_ids[16 * 33 + 21], 0U);
        EXPECT_EQ(frame.edge[16 * 33 + 18], 0);
        EXPECT_EQ(frame.edge[18 * 33 + 18], surface == Surface::mesh ? 1 : 0); // the diagonal
        EXPECT_EQ(frame.edge[16 * 33 + 21], 0);
    }
    scene.objects[0].mesh = BoxShape{{8.0 / 8.25, 8.0 / 8.25, 4}, 1}; // 8 pixels: from centre 12 to centre 20
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame frame = render(scene, {}, size, surface);
        EXPECT_EQ(frame.edge[16 * 33 + 12], 1);
        EXPECT_EQ(frame.edge[16 * 33 + 20], 1);
        EXPECT_EQ(frame.edge[16 * 33 + 21], 0);
    }
}

TEST(ReferenceMasks, SurfacesThatFightForTheDepthBufferAreMarked) {
    Scene scene = ball({0, 0, 4});
    scene.objects.push_back(scene.objects[0]);
    const Size size{21, 21};
    const ReferenceFrame twice = render(scene, {}, size);
    EXPECT_EQ(twice.object_ids[10 * 21 + 12], 1U); // the first drawn
    EXPECT_EQ(twice.edge[10 * 21 + 12], 1);
    scene.objects[1].transform.scale = glm::dvec3(0.99);
    EXPECT_EQ(render(scene, {}, size).edge[9 * 21 + 12], 0);
}

} // namespace
} // namespace sandbox
