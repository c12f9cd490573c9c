#include "measure/metrics/metrics.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "shading/features.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <optional>

/// The float32 pictures of the built-in scenes against the same technique in double on the same mesh.
namespace sandbox {
namespace {

class Truth : public GlTest {
  protected:
    /// Every compared pixel within `bound` of the truth, or within what rounding its triangle's place in the window to
    /// float32 does to the truth itself: on slivers of 1/50 pixel and under sharp highlights that is more.
    /// Returns how many pixels needed that.
    std::size_t expect_within(const Scene &scene, const std::string &technique, double bound, Size size = {320, 240}) {
        SCOPED_TRACE(scene.name + " " + technique);
        const Technique parsed = parse_technique(technique);
        const std::vector<ObjectResources> resources = renderer_.resources().load(scene);
        const Frame drawn = renderer_.render(scene, parsed, size, true);
        const ReferenceFrame truth = render_reference(scene, resources, parsed, size);
        const Metrics metrics = compare(drawn, truth, Flip::without);
        expect_all_counted(metrics);
        const std::size_t few = metrics.compared_pixels / 1000; // rounding is an excuse for the few
        std::size_t beyond = 0;
        for (std::size_t i = 0; i < truth.color.size(); ++i) {
            const double error = difference(drawn, truth, i);
            if (error > bound && ++beyond <= few) {
                expect_rounding_explains(error, bound, *probe(scene, resources, parsed, size, i));
            }
        }
        EXPECT_LE(beyond, few);
        std::printf("%-28s %-44s %9.2e of %9.2e, %zu beyond\n", scene.name.c_str(), technique.c_str(),
                    metrics.norms.max_abs, bound, beyond);
        return beyond;
    }

    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};

  private:
    static void expect_all_counted(const Metrics &metrics) {
        const std::size_t shown = metrics.compared_pixels + metrics.silhouette_pixels + metrics.edge_pixels +
                                  metrics.jump_pixels + metrics.rounding_pixels;
        EXPECT_EQ(metrics.nonfinite_pixels, 0U);
        EXPECT_LT(static_cast<double>(metrics.silhouette_pixels), 0.005 * static_cast<double>(shown));
        // What is left out must stay little: under 2 % of what is shown, in every scene and technique.
        EXPECT_GT(static_cast<double>(metrics.compared_pixels), 0.98 * static_cast<double>(shown));
    }

    /// 0 for a pixel that is not compared.
    static double difference(const Frame &drawn, const ReferenceFrame &truth, std::size_t i) {
        const std::uint32_t id = truth.object_ids[i];
        if (id == 0 || drawn.object_ids[i] != id || truth.edge[i] != 0 || truth.jump[i] != 0 ||
            truth.rounding[i] != 0) {
            return 0;
        }
        const glm::dvec3 d = glm::abs(glm::dvec3(drawn.color.pixels[i]) - truth.color[i]);
        return std::max({d.x, d.y, d.z});
    }

    static std::optional<PixelProbe> probe(const Scene &scene, const std::vector<ObjectResources> &resources,
                                           const Technique &technique, Size size, std::size_t i) {
        const auto width = static_cast<std::size_t>(size.width);
        return probe_pixel(scene, resources, technique, size, static_cast<int>(i % width), static_cast<int>(i / width));
    }

    static void expect_rounding_explains(double error, double bound, const PixelProbe &probe) {
        EXPECT_LE(error, bound + probe.window_rounding) << "object " << probe.object << ", triangle " << probe.triangle;
    }
};

/// The bound of a picture: that of its dullest exponent, so that no object hides behind a shinier one.
double picture_bound(const Scene &scene, const std::string &technique) {
    const Technique parsed = parse_technique(technique);
    if (parsed.model == Model::lambert || parsed.power == Power::stable) {
        return 2e-5;
    }
    double n = 1e9;
    for (const Object &object : scene.objects) {
        n = std::min(n, raised_exponent(scene, parsed.model, object.material));
    }
    return 2e-5 + 4e-7 * n;
}

/// The bound is 2e-5 of linear colour where the power is stable; rounding adds to that where it is a textbook's.
TEST_F(Truth, PerPixelPicturesOfEveryScene) {
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const Scene scene = open_scene(name, Assets("assets"));
        for (const char *technique : {"per-pixel/lambert", "per-pixel/phong", "per-pixel/blinn-phong",
                                      "per-pixel/phong:power=stable", "per-pixel/blinn-phong:power=stable"}) {
            EXPECT_EQ(expect_within(scene, technique, picture_bound(scene, technique)), 0U);
        }
    }
}

/// The same technique in double on both sides.
TEST_F(Truth, OtherFrequenciesOfEveryScene) {
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const Scene scene = open_scene(name, Assets("assets"));
        for (const std::string model : {"/lambert", "/phong", "/blinn-phong"}) {
            for (const std::string frequency : {"flat", "per-vertex", "interpolated-vectors", "hybrid"}) {
                if (frequency + model != "hybrid/lambert") {
                    expect_within(scene, frequency + model, picture_bound(scene, frequency + model));
                }
            }
        }
    }
}

Scene with_exponent(Scene scene, double n) {
    for (Object &object : scene.objects) {
        object.material.shininess = n;
    }
    return scene;
}

TEST_F(Truth, ExponentsUpToTenThousand) {
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        for (const double n : {1.0, 8.0, 128.0, 1000.0, 1e4}) {
            const Scene scene = with_exponent(open_scene(name, Assets("assets")), n);
            for (const std::string technique : {"per-pixel/phong", "per-pixel/blinn-phong"}) {
                expect_within(scene, technique, 2e-5 + 4e-7 * n);
                expect_within(scene, technique + ":power=stable", 2e-5);
            }
        }
    }
}

TEST_F(Truth, LargerPictures) {
    for (const Size size : {Size{800, 600}, Size{1280, 720}}) {
        for (const std::string &name : builtin_scenes(Assets("assets"))) {
            const Scene scene = open_scene(name, Assets("assets"));
            expect_within(scene, "per-pixel/phong", picture_bound(scene, "per-pixel/phong"), size);
            expect_within(with_exponent(scene, 1), "per-pixel/blinn-phong", 2e-5 + 4e-7, size);
        }
    }
}

/// Where normals are not interpolated (a box, a floor), power = stable keeps 2e-5 whatever the exponent.
TEST_F(Truth, StablePowerOnFlatFaces) {
    Scene scene = open_scene("box-5-specular", Assets("assets"));
    scene.objects.push_back({"floor", PlaneShape{{8, 8}, 8}, {}, {}, false});
    scene.objects.back().transform.translate = {0, -1.5, 0};
    for (const double n : {1.0, 8.0, 128.0, 1000.0, 1e4}) {
        EXPECT_EQ(expect_within(with_exponent(scene, n), "per-pixel/phong:power=stable", 2e-5), 0U);
        EXPECT_EQ(expect_within(with_exponent(scene, n), "per-pixel/blinn-phong:power=stable", 2e-5), 0U);
    }
}

} // namespace
} // namespace sandbox
