#include "image/error.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/feature_scenes.h"
#include "tools/gl_test.h"
#include "tools/technique_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace sandbox {
namespace {

class Metamorphic : public GlTest {
  protected:
    /// Pixels that differ by more than `bound` are few, and by what rounding their triangle's place in the window does
    /// to the truth itself, of either picture.
    void expect_rounding_explains(const Image &a, const Image &b, double bound, const Scene &scene,
                                  const Technique &technique) {
        const std::vector<ObjectResources> resources = renderer_.resources().load(scene);
        int beyond = 0;
        for (int y = 0; y < a.size.height; ++y) {
            for (int x = 0; x < a.size.width; ++x) {
                const auto i = static_cast<std::size_t>(y * a.size.width + x);
                const glm::dvec3 apart = glm::abs(glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]));
                const double largest = std::max({apart.x, apart.y, apart.z});
                if (largest <= bound) {
                    continue;
                }
                const auto probe = probe_pixel(scene, resources, technique, a.size, x, y);
                ASSERT_TRUE(probe) << x << ", " << y;
                EXPECT_LE(largest, bound + 2 * probe->window_rounding) << x << ", " << y;
                ++beyond;
            }
        }
        EXPECT_LE(beyond, a.size.width * a.size.height / 1000);
    }

    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

struct Difference {
    double largest = 0;   ///< NaN counts as infinite
    double brightest = 0; ///< of either picture
};

Difference difference(const Image &a, const Image &b) {
    Difference result;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const double x = a.pixels[i][channel];
            const double y = b.pixels[i][channel];
            const double apart = std::abs(x - y);
            result.largest = std::isfinite(apart) ? std::max(result.largest, apart) : INFINITY;
            result.brightest = std::max({result.brightest, x, y});
        }
    }
    return result;
}

/// Both programs run the same operations in the same order on the same varyings, so they differ by the rounding of
/// values that one of them folds into constants; and, as Mesa 25 compiles them, of a product and a sum that are one
/// operation in one of them alone. Textbook power above n = 1024 is excepted.
TEST_F(Metamorphic, SpecialisedAndFullProgramGiveTheSamePicture) {
    constexpr Size size{160, 120};
    int compared = 0;
    for (const Scene &scene : feature_scenes()) {
        for (Technique technique : pairwise_techniques()) {
            technique.program = Program::full;
            technique.precision = Precision::high; // refused beside it
            if (why_refused(technique) ||
                (technique.power == Power::textbook && scene.objects[0].material.shininess > 1024)) {
                continue;
            }
            const Image full = renderer_.render(scene, technique, size).color;
            technique.program = Program::specialised;
            const Image specialised = renderer_.render(scene, technique, size).color;
            const Difference d = difference(full, specialised);
            ASSERT_TRUE(std::isfinite(d.largest)) << scene.name << " " << to_string(technique);
            if (d.largest > 1e-5 * d.brightest) {
                SCOPED_TRACE(scene.name + " " + to_string(technique));
                expect_rounding_explains(full, specialised, 1e-5 * d.brightest, scene, technique);
            }
            ++compared;
        }
    }
    EXPECT_GT(compared, 200);
}

TEST_F(Metamorphic, BuiltInScenesLookTheSameUnderTheFullProgram) {
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const Scene scene = open_scene(name, Assets("assets"));
        for (const char *text : {"per-vertex/phong", "per-pixel/phong", "per-pixel/blinn-phong", "hybrid/blinn-phong",
                                 "flat/lambert", "interpolated-vectors/phong"}) {
            Technique technique = parse_technique(text);
            const Image specialised = renderer_.render(scene, technique, {160, 120}).color;
            technique.program = Program::full;
            const Difference d = difference(renderer_.render(scene, technique, {160, 120}).color, specialised);
            EXPECT_LE(d.largest, 1e-5 * d.brightest) << name << " " << text;
        }
    }
}

/// A baked program raises by multiplications, which errs by (n - 1) 2^-24; pow() is allowed 2e-5 + 4e-7 n. It folds
/// what it knows, which moves every argument by its rounding, 6e-8; the edge of a cone, the steepest thing here, makes
/// up to a thousand times that of it. As above, textbook power above n = 1024 is excepted.
TEST_F(Metamorphic, BakedAndSpecialisedProgramGiveTheSamePicture) {
    constexpr Size size{160, 120};
    int compared = 0;
    for (const Scene &scene : feature_scenes()) {
        for (Technique technique : pairwise_techniques()) {
            technique.program = Program::baked;
            const double shininess = scene.objects[0].material.shininess;
            if (why_refused(technique) || technique.power == Power::naive ||
                (technique.power == Power::textbook && shininess > 1024)) {
                continue;
            }
            const Image baked = renderer_.render(scene, technique, size).color;
            technique.program = Program::specialised;
            const Image specialised = renderer_.render(scene, technique, size).color;
            const Difference d = difference(baked, specialised);
            const double n = std::min(shininess, stable_power_from);
            EXPECT_LE(d.largest, (8e-5 + 4e-7 * n) * d.brightest) << scene.name << " " << to_string(technique);
            ++compared;
        }
    }
    EXPECT_GT(compared, 200);
}

/// A quarter turn about y and a shift, both exact in binary, of everything there is: the picture must not care where
/// the world's origin is. Faults that are about the origin (w0, constant half vector) are left out.
TEST_F(Metamorphic, MovingSceneAndCameraTogetherGivesTheSamePicture) {
    const auto turn = [](const glm::dvec3 &v) { return glm::dvec3(v.z, v.y, -v.x); };
    const auto move = [&](const glm::dvec3 &p) { return turn(p) + glm::dvec3(64, -32, 128); };
    for (const char *text : {"per-pixel/blinn-phong", "per-vertex/phong", "interpolated-vectors/blinn-phong",
                             "flat/phong", "hybrid/phong", "per-pixel/phong:viewer=infinite,gate=view-facing"}) {
        for (const Scene &scene : feature_scenes()) {
            Scene moved = scene;
            moved.camera.position = move(scene.camera.position);
            moved.camera.target = move(scene.camera.target);
            moved.camera.up = turn(scene.camera.up);
            for (Light &light : moved.lights) {
                light.position = move(light.position);
                light.direction = turn(light.direction);
            }
            Object &object = moved.objects[0];
            object.transform.translate = move(object.transform.translate);
            if (object.transform.rotate_degrees.z != 0 ||
                (object.transform.rotate_degrees.x != 0 && object.transform.rotate_degrees.y != 0)) {
                continue; // Ry(90) Rx = one rotation of the file only where Ry stands outermost alone
            }
            object.transform.rotate_degrees.y += 90;
            const Technique technique = parse_technique(text);
            const Image here = renderer_.render(scene, technique, {120, 90}).color;
            const Image there = renderer_.render(moved, technique, {120, 90}).color;
            // The turned vertices and matrices round differently (6e-8), and the rasteriser's interpolation magnifies
            // that on triangles of a few pixels by up to some hundreds; a pixel on an edge may change hands.
            std::size_t different = 0;
            for (std::size_t i = 0; i < here.pixels.size(); ++i) {
                const glm::vec4 apart = glm::abs(here.pixels[i] - there.pixels[i]);
                different += std::max({apart.r, apart.g, apart.b}) <= 2e-4F * 4 ? 0U : 1U;
            }
            EXPECT_LE(different, here.pixels.size() / 500) << scene.name << " " << text;
        }
    }
}

} // namespace
} // namespace sandbox
