#include "reference/raster.h"
#include "reference/reference.h"

#include "reference/reference_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

/// A pixel is left out only where something that adds light there jumps, or cannot be told apart.
namespace sandbox {
namespace {

using test::render;

std::ptrdiff_t count(const std::vector<std::uint8_t> &mask) { return std::count(mask.begin(), mask.end(), 1); }

Technique technique(const char *text) { return parse_technique(text); }

/// A box with a lamp at a corner that the camera sees, where no direction to it exists, and daylight.
Scene lamp_at_a_corner() {
    Scene scene;
    scene.camera.position = {2, 2.5, 2};
    scene.objects.push_back(test::object_of(BoxShape{}));
    scene.lights.push_back(test::directional_light({-1, -2, -1.5}));
    scene.lights.push_back(test::point_light({0.5, 0.5, 0.5}));
    return scene;
}

/// Every way to make the lamp at a corner give nothing.
std::vector<Scene> lamps_that_give_nothing() {
    std::vector<Scene> scenes(4, lamp_at_a_corner());
    scenes[0].lights[1].color = {0, 0, 0};
    scenes[1].lights[1].diffuse = scenes[1].lights[1].specular = 0;
    scenes[2].objects[0].material.diffuse = scenes[2].objects[0].material.specular = {0, 0, 0};
    scenes[3].lights[1].color = {0, 1, 0}; // a green lamp on a red box
    scenes[3].objects[0].material.diffuse = scenes[3].objects[0].material.specular = {1, 0, 0};
    scenes.push_back(lamp_at_a_corner()); // black all over
    scenes.back().objects[0].material.checker = Checker{4, {glm::dvec3(0), glm::dvec3(0)}};
    return scenes;
}

TEST(OwedMasks, ALampThatGivesNothingMasksNothing) {
    const Size size{64, 64};
    for (const char *text : {"per-vertex/phong", "hybrid/phong", "interpolated-vectors/blinn-phong",
                             "per-vertex/lambert:ambient=where-lit"}) {
        const Technique t = technique(text);
        EXPECT_GT(count(render(lamp_at_a_corner(), t, size).rounding), 300) << text << ": whole triangles";
        for (const Scene &scene : lamps_that_give_nothing()) {
            const ReferenceFrame frame = render(scene, t, size);
            EXPECT_EQ(count(frame.jump) + count(frame.rounding), 0) << text;
        }
    }
}

TEST(OwedMasks, AConesEdgeOnASurfaceThatIsTurnedAway) {
    const Size size{401, 401};
    const Technique t = technique("per-pixel/phong");
    const auto masked = [&](const Scene &scene) { return count(render(scene, t, size).jump); };
    Scene scene = test::spot_over_a_plane();
    EXPECT_GT(masked(scene), 0);
    scene.lights[0].position = {0, -1, 0}; // from below: N.L < 0, and the gate is shut
    scene.lights[0].direction = {0, 1, 0};
    EXPECT_EQ(masked(scene), 0);
    scene.objects[0].material.shininess = 0; // f^0 = 1: a highlight everywhere
    EXPECT_EQ(masked(scene), 0);
    EXPECT_GT(count(render(scene, technique("per-pixel/phong:gate=none"), size).jump), 0) << "it shines through";
    scene.lights[0].attenuate_ambient = true;
    scene.lights[0].ambient = 1;
    EXPECT_GT(masked(scene), 0) << "ambient light does not ask for N.L";
}

TEST(OwedMasks, AGateBesideItsCone) {
    // The terminator of a ball lit from the side and behind, by a spot that points elsewhere: what the gate lets
    // through is dark.
    Scene scene = test::ball({-4, 0, -0.4});
    scene.objects[0].material.shininess = 0.25;
    const Size size{301, 301};
    const Technique t = technique("per-pixel/phong");
    EXPECT_GT(count(render(scene, t, size).jump), 0);
    scene.lights[0].type = LightType::spot;
    scene.lights[0].direction = {-1, 0, 0};
    EXPECT_EQ(count(render(scene, t, size).jump), 0);
}

TEST(OwedMasks, CellBordersInTheDark) {
    Scene scene = test::ball({-1e3, 0, 0});
    scene.objects[0].material.checker = Checker{};
    const Size size{201, 201};
    const ReferenceFrame frame = render(scene, technique("per-pixel/lambert"), size);
    const auto at = [&](int x, int y) { return frame.jump[static_cast<std::size_t>(y * 201 + x)]; };
    EXPECT_EQ(at(80, 100), 1) << "on the plane y = 0, in the light";
    EXPECT_EQ(at(120, 100), 0) << "on the plane y = 0, in the dark";
    scene.objects[0].material.checker->colors[1] = scene.objects[0].material.checker->colors[0];
    EXPECT_EQ(count(render(scene, technique("per-pixel/lambert"), size).jump), 0) << "all cells have one colour";
}

/// A square that faces the camera, its normals turned from +x at the left to -x at the right: they cancel in the
/// middle.
ReferenceFrame cancelling_normals(const Scene &scene, const char *text, Size size) {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals = {{1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, {1, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.bounds = {{-1, -1, 0}, {1, 1, 0}};
    return render_reference(scene, {{std::make_shared<const Mesh>(mesh), nullptr}}, technique(text), size);
}

TEST(OwedMasks, NormalsThatCancelMatterWhereLightReadsThem) {
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.objects.push_back(test::object_of(PlaneShape{}));
    scene.lights.push_back(test::directional_light({-1, 0, -1}));
    const Size size{101, 101};
    const ReferenceFrame half_lit = cancelling_normals(scene, "per-pixel/phong", size);
    EXPECT_EQ(half_lit.rounding[50 * 101 + 49], 1);
    EXPECT_EQ(half_lit.rounding[50 * 101 + 51], 0) << "turned away, and 3e-5 turn it to no light";
    scene.lights.push_back(test::directional_light({1, 0, -1}));
    // N is 0 in the middle column; one pixel beside it, it is 0.033 long, and float32 turns it by 3e-5.
    const ReferenceFrame lit = cancelling_normals(scene, "per-pixel/lambert", size);
    EXPECT_EQ(lit.rounding[50 * 101 + 50], 1);
    EXPECT_EQ(lit.rounding[50 * 101 + 51], 1);
    EXPECT_EQ(lit.rounding[50 * 101 + 57], 0) << "0.23 long: turned by 4e-6, far below any bound";
    EXPECT_EQ(count(cancelling_normals(scene, "per-vertex/lambert", size).rounding), 0) << "no normal is interpolated";
    // With N = -x and the light 45 degrees to the left, R.V = -0.71: no rounding makes a highlight of it. N.H = 0.38.
    EXPECT_EQ(count(cancelling_normals(scene, "per-pixel/phong", size).rounding), count(lit.rounding));
    scene.objects[0].material.shininess = 1;
    EXPECT_GT(count(cancelling_normals(scene, "per-pixel/blinn-phong", size).rounding), count(lit.rounding));
    scene.lights[0].color = scene.lights[1].color = {0, 0, 0};
    scene.ambient = {1, 1, 1};
    EXPECT_EQ(count(cancelling_normals(scene, "per-pixel/phong", size).rounding), 0);
}

TEST(OwedMasks, ACornersVectorsThatCancel) {
    // The lamp hangs close above the middle of a square of two triangles: half way along the diagonal the corners'
    // directions to it cancel but for the little that points up.
    Scene scene;
    scene.camera.position = {0, 4, 0.1};
    scene.objects.push_back(test::object_of(PlaneShape{{2, 2}, 1}));
    scene.lights.push_back(test::point_light({0, 1e-3, 0}));
    const Size size{101, 101};
    EXPECT_GT(count(render(scene, technique("interpolated-vectors/lambert"), size).rounding), 3);
    EXPECT_EQ(count(render(scene, technique("per-pixel/lambert"), size).rounding), 0);
    scene.lights[0].position.y = 1; // 0.58 of each corner's direction points up
    EXPECT_EQ(count(render(scene, technique("interpolated-vectors/phong"), size).rounding), 0);
}

/// Where a lamp stands on a vertex its light may come from anywhere within its cone, and from nowhere else.
TEST(OwedMasks, ALampAtACornerWhoseConeMeetsNoSide) {
    Scene scene = lamp_at_a_corner();
    scene.lights[1].type = LightType::spot;
    scene.lights[1].cutoff_degrees = scene.lights[1].inner_cutoff_degrees = 20;
    for (const char *text : {"per-vertex/phong", "hybrid/phong", "interpolated-vectors/blinn-phong"}) {
        scene.lights[1].direction = {1, 1, 1}; // away from the box
        EXPECT_EQ(count(render(scene, technique(text), {64, 64}).rounding), 0) << text;
        scene.lights[1].direction = {-1, -1, -1};
        EXPECT_GT(count(render(scene, technique(text), {64, 64}).rounding), 100) << text;
    }
}

/// Ambient light that is switched by N.L asks for no cone.
TEST(OwedMasks, AmbientWhereLitOfALampAtACornerWhoseConeMeetsNoSide) {
    Scene scene = lamp_at_a_corner();
    scene.lights[1].type = LightType::spot;
    scene.lights[1].cutoff_degrees = scene.lights[1].inner_cutoff_degrees = 20;
    scene.lights[1].direction = {1, 1, 1};
    const auto masked = [&](const char *text) { return count(render(scene, technique(text), {64, 64}).rounding); };
    scene.lights[1].ambient = 1;
    EXPECT_GT(masked("per-vertex/lambert:ambient=where-lit"), 100);
    EXPECT_EQ(masked("per-vertex/lambert"), 0);
    scene.lights[1].attenuate_ambient = true;
    EXPECT_EQ(masked("per-vertex/lambert:ambient=where-lit"), 0) << "the cone darkens it, too";
}

/// H lies within 90 degrees of V, whatever L is: a vertex whose normal is turned away has no narrow highlight.
TEST(OwedMasks, ALampAtACornerThatIsTurnedAway) {
    Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.objects.push_back(test::object_of(PlaneShape{}));
    scene.objects[0].material.diffuse = {0, 0, 0};
    scene.lights.push_back(test::point_light({-1, -1, 0}));
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.bounds = {{-1, -1, 0}, {1, 1, 0}};
    const auto masked = [&](double n_z, double shininess) {
        mesh.normals.assign(3, {0, 0.6, n_z});
        scene.objects[0].material.shininess = shininess;
        const Technique t = technique("per-vertex/blinn-phong");
        return count(render_reference(scene, {{std::make_shared<const Mesh>(mesh), nullptr}}, t, {64, 64}).rounding);
    };
    EXPECT_GT(masked(0.8, 200), 100);
    EXPECT_EQ(masked(-0.8, 200), 0) << "N.H is at most 0.7";
    EXPECT_GT(masked(-0.8, 1), 100);
}

TEST(OwedMasks, VectorsThatCancelFarFromANarrowHighlight) {
    Scene scene;
    scene.camera.position = {0, 3, 3};
    scene.objects.push_back(test::object_of(PlaneShape{{2, 2}, 1}));
    scene.objects[0].material.diffuse = {0, 0, 0};
    scene.lights.push_back(test::point_light({0, 1e-3, 0}));
    const auto masked = [&](double shininess, const char *text) {
        scene.objects[0].material.shininess = shininess;
        return count(render(scene, technique(text), {101, 101}).rounding);
    };
    EXPECT_GT(masked(1, "interpolated-vectors/phong"), 3);
    EXPECT_EQ(masked(2000, "interpolated-vectors/phong"), 0) << "45 degrees from the mirrored direction";
    scene.lights[0].position = {1, 0, 1}; // on a vertex
    EXPECT_GT(masked(1, "interpolated-vectors/blinn-phong"), 2 * masked(2000, "interpolated-vectors/blinn-phong"));
    EXPECT_GT(masked(2000, "interpolated-vectors/blinn-phong"), 100) << "near the vertex H may be N";
}

/// Programs tell such a cone by sines: what they lose of a direction, 1e-6 and less, counts as an angle, not as a
/// cosine, which would be an angle of 1e-3.
TEST(OwedMasks, AConeNarrowerThanRounding) {
    Scene scene = test::spot_over_a_plane();
    scene.lights[0].cutoff_degrees = scene.lights[0].inner_cutoff_degrees = 5e-6;
    const Size size{401, 401};
    const auto masked = [&] { return count(render(scene, technique("per-pixel/phong"), size).jump); };
    EXPECT_LE(masked(), 4);
    scene.camera.position = {0, 1e-2, 0}; // 5e-5 a pixel
    scene.camera.near_plane = 1e-3;
    EXPECT_LE(masked(), 4);
    scene.camera.position = {0, 1e-4, 0}; // 5e-7 a pixel
    scene.camera.near_plane = 1e-5;
    EXPECT_GE(masked(), 4);
    scene.lights[0].inner_cutoff_degrees = 0; // an edge that rounding spans is as good as a hard one
    EXPECT_GE(masked(), 4);
    scene.lights[0].inner_cutoff_degrees = 0.001;
    scene.lights[0].cutoff_degrees = 0.002;
    EXPECT_EQ(masked(), 0);
}

/// Twice the same ball: which one is seen is chance, and object ids tell it. What this one looks like is no chance.
TEST(OwedMasks, ARivalHidesNothing) {
    Scene scene = test::ball({0, 3, 4});
    scene.objects.push_back(scene.objects[0]);
    const Size size{65, 65};
    const Technique t = technique("per-pixel/phong");
    const ReferenceFrame twice = render(scene, t, size);
    EXPECT_GT(count(twice.edge), 1000);
    EXPECT_GT(count(twice.rival), 1000);
    scene.objects[1].mesh = BoxShape{glm::dvec3(0.01), 1};
    EXPECT_EQ(count(render(scene, t, size).rival), 0);
    scene.objects.resize(1);
    EXPECT_EQ(count(render(scene, t, size).rival), 0);
}

/// OpenGL lights an object that is far for its size in positions from the object's own middle, not from the eye.
TEST(OwedMasks, ABallInATelescopeIsCompared) {
    Scene scene = test::ball({1.2, 1.1, 1.4});
    scene.camera = {{0, 0, 1e6}, {0, 0, 0}, {0, 1, 0}, 1.8e-4, 5e5, 2e6};
    const Size size{65, 65};
    for (const Surface surface : {Surface::mesh, Surface::analytic}) {
        const ReferenceFrame frame = render(scene, technique("per-pixel/phong"), size, surface);
        EXPECT_GT(std::count(frame.object_ids.begin(), frame.object_ids.end(), 1U), 1000);
        EXPECT_EQ(count(frame.rounding), 0);
        EXPECT_LT(count(frame.jump), 30);
    }
}

TEST(OwedMasks, ADeepScenesDepthIsALogarithm) {
    Scene scene = test::ball({0, 3, 4});
    scene.objects.push_back(scene.objects[0]);
    const Size size{65, 65};
    const auto edges = [&] { return count(render(scene, technique("per-pixel/phong"), size).edge); };
    scene.objects[1].transform.scale = glm::dvec3(0.99);
    const std::ptrdiff_t shallow = edges();
    scene.camera.near_plane = 1e-6;
    scene.camera.far_plane = 1000;
    EXPECT_EQ(edges(), shallow) << "surfaces 0.01 apart at a distance of 3 are told apart";
    scene.objects[1].transform.scale = glm::dvec3(1);
    EXPECT_GT(edges(), 1000) << "twice the same surface is not";
}

TEST(OwedMasks, TheStepOfALogarithmicDepthIsAShareOfTheDistance) {
    using reference::Corner;
    const std::vector<glm::uvec3> one{{0, 1, 2}};
    const auto tie = [&](double distance, double apart, double near, double far) {
        const auto facing = [&](double w) {
            const Corner low(-10 * w, -10 * w, w);
            return reference::RasterObject{{low, {30 * w, -10 * w, w}, {-10 * w, 30 * w, w}}, &one, 0};
        };
        const std::vector<reference::RasterObject> objects{facing(distance), facing(distance * (1 + apart))};
        return reference::Rasteriser(objects, {3, 3}, {near, far, true}).draw(0)[4].tie;
    };
    // 4e-7 of the depth range is 4e-7 ln(far / near) of the distance; interpolating 1 / w adds 2^-22 of it.
    for (const double distance : {1e-3, 1.0, 1e4}) {
        const double step = 4e-7 * std::log(1e12) + 0x1p-22;
        EXPECT_TRUE(tie(distance, 0.9 * step, 1e-6, 1e6)) << distance;
        EXPECT_FALSE(tie(distance, 1.1 * step, 1e-6, 1e6)) << distance;
    }
}

} // namespace
} // namespace sandbox
