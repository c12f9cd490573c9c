#include "reference/reference.h"
#include "render/renderer.h"
#include "render/seen_part.h"
#include "scene/scene_file.h"
#include "shading/prepared_object.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <cmath>
#include <string>

/// Views that magnify: an eye far away, or close with a lens of a thousandth of a degree. Float32 positions from the
/// eye have no digits left for what such views show.
namespace sandbox {
namespace {

constexpr Size size{200, 150};
constexpr double one_level = 1.0 / 255;

Scene case_scene(const std::string &name) {
    return open_scene(TEST_DATA_DIR "/lighting/" + name + ".json", Assets("assets"));
}

class NarrowViews : public GlTest {
  protected:
    /// The largest difference from the truth where both show the object, jumps included: no mask may hide anything.
    double error(const Scene &scene, const std::string &technique) {
        const ReferenceFrame truth =
            render_reference(scene, renderer_.resources().load(scene), parse_technique(technique), size);
        const Frame drawn = renderer_.render(scene, parse_technique(technique), size, true);
        double largest = 0;
        std::size_t compared = 0;
        for (std::size_t i = 0; i < truth.color.size(); ++i) {
            if (truth.object_ids[i] != 0 && drawn.object_ids[i] == truth.object_ids[i] && truth.edge[i] == 0) {
                const glm::dvec3 off = glm::abs(glm::dvec3(drawn.color.pixels[i]) - truth.color[i]);
                largest = std::max({largest, off.x, off.y, off.z});
                ++compared;
            }
        }
        EXPECT_GT(compared, 5000U) << scene.name << ", " << technique;
        return largest;
    }
    std::shared_ptr<const Mesh> seen_mesh(const Scene &scene, const char *technique) {
        return seen_parts(scene, parse_technique(technique), renderer_.resources().load(scene), size.width / 150.0)[0]
            .mesh;
    }
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

TEST_F(NarrowViews, FromAfarLightingKeepsItsDigits) {
    for (const char *frequency : {"flat", "per-vertex", "per-pixel", "interpolated-vectors", "hybrid"}) {
        for (const char *rest : {"/phong", "/blinn-phong", "/phong:program=full"}) {
            const std::string technique = std::string(frequency) + rest;
            // From the eye a position errs by 0.06 of the ball's radius. n = 64: 2e-5 + 4e-7 n, as at any distance.
            EXPECT_LE(error(case_scene("telescope"), technique), 5e-5) << technique;
        }
    }
    // n = 1e5; the stable form keeps sqrt(n) 6e-8 and more where N.L is small.
    EXPECT_LE(error(case_scene("stiff_far"), "per-pixel/phong"), 1e-4);
    EXPECT_LE(error(case_scene("stiff_far"), "per-pixel/blinn-phong"), 1e-4);
}

TEST_F(NarrowViews, AnEdgeOfAThousandthOfADegreeIsSharp) {
    // The edge is 8.7e-6 of a radian wide, the light's float32 direction errs by 3e-8: half a level and a little more.
    EXPECT_LE(error(case_scene("narrow_soft_spot"), "per-pixel/phong"), one_level);
    EXPECT_LE(error(case_scene("narrow_soft_spot"), "per-pixel/lambert:program=full"), one_level);
}

/// Over two triangles of 2e6 units float32 places a pixel to 0.06 of a unit, of the four that the picture shows.
TEST_F(NarrowViews, AnOrthographicFloorWithoutEndKeepsItsDigits) {
    Scene scene;
    scene.camera = {.position = {3, 3, 4}};
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 4;
    scene.objects = {{"floor", PlaneShape{{2e6, 2e6}, 1}, {}, {}, false}};
    scene.lights.resize(1);
    scene.lights[0].position = {1, 2, 0};
    EXPECT_LE(error(scene, "per-pixel/phong"), 5e-5); // n = 32
    EXPECT_LE(error(scene, "per-pixel/blinn-phong:program=full"), 5e-5);
}

/// Flattened to 2e-23, with a light in its middle: from its own middle, squares of such lengths vanish in float32.
TEST_F(NarrowViews, AFlattenedSpeckWithALightInItIsFinite) {
    Scene scene;
    scene.camera = {.position = {0, 0, 2e-7}, .fov_y_degrees = 0.007, .near_plane = 2.845e-9};
    scene.lights.resize(1);
    scene.objects = {{"speck", CylinderShape{1, 2, 24, 2, false}, {{}, {0, -80, 1}, {-2e-23, 2e-12, 2e-12}}, {}, true}};
    for (const char *technique :
         {"hybrid/phong", "hybrid/blinn-phong", "per-pixel/phong", "per-pixel/phong:program=full"}) {
        const Frame drawn = renderer_.render(scene, parse_technique(technique), size, true);
        EXPECT_GT(std::count(drawn.object_ids.begin(), drawn.object_ids.end(), 1U), 0) << technique;
        for (const glm::vec4 &color : drawn.color.pixels) {
            ASSERT_TRUE(std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b)) << technique;
        }
    }
}

TEST_F(NarrowViews, OnlyTheyPayForIt) {
    Scene scene = case_scene("narrow_soft_spot");
    const auto whole = renderer_.resources().load(scene)[0].mesh;
    const auto part = seen_mesh(scene, "per-pixel/phong");
    EXPECT_NE(part, whole);
    EXPECT_LT(part->bounds.high.x - part->bounds.low.x, 0.01 * (whole->bounds.high.x - whole->bounds.low.x));
    for (const glm::dvec3 &normal : part->normals) {
        EXPECT_EQ(normal, glm::dvec3(0, 1, 0));
    }
    EXPECT_EQ(seen_mesh(scene, "per-vertex/phong"), whole); // interpolates colours of the mesh's own vertices
    EXPECT_EQ(seen_mesh(scene, "per-pixel/phong:renormalize=off"), whole);
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 10;
    EXPECT_EQ(seen_mesh(scene, "per-pixel/phong"), whole);
    scene.camera.height = 1e-3;
    const auto box = seen_mesh(scene, "per-pixel/phong");
    EXPECT_NE(box, whole);
    EXPECT_LT(box->bounds.high.x - box->bounds.low.x, 0.01 * (whole->bounds.high.x - whole->bounds.low.x));
    EXPECT_EQ(seen_mesh(scene, "per-vertex/phong"), whole);
    scene.camera.projection = Projection::perspective;
    scene.camera.fov_y_degrees = 45;
    EXPECT_EQ(seen_mesh(scene, "per-pixel/phong"), whole);
    const auto is_lit_afar = [&](const Scene &s) {
        return object_features(s, parse_technique("per-pixel/phong"), renderer_.resources().load(s))[0].afar;
    };
    EXPECT_FALSE(is_lit_afar(scene));
    EXPECT_TRUE(is_lit_afar(case_scene("telescope")));
    EXPECT_TRUE(is_lit_afar(case_scene("stiff_far")));
}

} // namespace
} // namespace sandbox
