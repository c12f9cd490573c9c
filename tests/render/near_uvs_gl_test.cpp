#include "measure/metrics/metrics.h"
#include "render/renderer.h"
#include "scene/near_uvs.h"
#include "scene/scene_file.h"
#include "tools/gl_test.h"
#include "tools/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

/// Textures whose coordinates are far from 0, on the renderer against the truth.
namespace sandbox {
namespace {

constexpr Size size{160, 120};

std::string square(double u, double v, double across = 1) {
    const auto vt = [](double s, double t) { return "vt " + std::to_string(s) + " " + std::to_string(t) + "\n"; };
    return "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\n" + vt(u, v) + vt(u + across, v) +
           vt(u + across, v + across) + vt(u, v + across) + "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
}

/// The most that a texel differs from the next.
double contrast(const Image &image) {
    float most = 0;
    const auto differ = [&](const glm::vec4 &a, const glm::vec4 &b) {
        most = std::max({most, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    };
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            differ(image.at(x, y), image.at((x + 1) % image.size.width, y));
            differ(image.at(x, y), image.at(x, (y + 1) % image.size.height));
        }
    }
    return most;
}

class NearUvsOnTheRenderer : public GlTest {
  protected:
    double error(const Scene &scene, const char *technique) {
        const auto resources = renderer_.resources().load(scene);
        const ReferenceFrame truth = render_reference(scene, resources, parse_technique(technique), size);
        const Metrics metrics =
            compare(renderer_.render(scene, parse_technique(technique), size, true), truth, Flip::without);
        EXPECT_GT(metrics.compared_pixels, 5000U);
        return metrics.norms.max_abs;
    }
    Scene scene_with(const std::string &obj) {
        Scene scene = open_scene(TEST_DATA_DIR "/lighting/uv_far.json", Assets("assets"));
        const std::string name = "square " + std::to_string(files_++) + ".obj";
        folder_.write(name, obj);
        scene.objects[0].mesh = ObjShape{folder_.file(name)};
        return scene;
    }
    /// near_uvs.h: (S + uv_step) 2^-21 repeats along each axis.
    double bound(double span) {
        const auto image = renderer_.resources().load(scene_with(square(0, 0)))[0].texture;
        return 2 * (span + uv_step) * 0x1p-21 * image->size.width * contrast(*image);
    }

    TemporaryFolder folder_;
    int files_ = 0;
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

/// Every frequency has its own vertex arrays: flat ones are not shared. The same square with coordinates from 0 to 1
/// says what float32 can do.
TEST_F(NearUvsOnTheRenderer, FarCoordinatesAreAsGoodAsNearOnes) {
    for (const char *technique : {"per-pixel/blinn-phong", "flat/lambert", "per-vertex/phong:program=full"}) {
        const double near = error(scene_with(square(0, 0)), technique);
        for (const double share : {1.0, 0.1, 0.02, -1.0}) {
            const double far = error(scene_with(square(500000 * share, 5e6 * share)), technique);
            EXPECT_LE(far, std::max(10 * near, 1e-4)) << technique << ", " << share; // |uv| up to 9 in place of 1
        }
    }
    EXPECT_LE(error(open_scene(TEST_DATA_DIR "/lighting/uv_far.json", Assets("assets")), "per-pixel/blinn-phong"),
              1e-4);
}

/// A square whose file counts to 6 and 4, and one whose material repeats the texture so often, are one picture.
TEST_F(NearUvsOnTheRenderer, RepeatsOfAMaterialAreThoseOfTheFile) {
    Scene written = scene_with(square(0, 0, 6));
    Scene repeated = scene_with(square(0, 0));
    repeated.objects[0].material.texture_repeat = {6, 6};
    const Technique technique = parse_technique("per-pixel/blinn-phong");
    const ReferenceFrame truth = render_reference(written, renderer_.resources().load(written), technique, size);
    const ReferenceFrame same = render_reference(repeated, renderer_.resources().load(repeated), technique, size);
    for (std::size_t i = 0; i < truth.color.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            ASSERT_NEAR(truth.color[i][c], same.color[i][c], 1e-11); // whole repeats are taken off in double
        }
    }
    // Six times as steep, and the product with 6 is rounded as its factor was.
    EXPECT_LE(error(repeated, "per-pixel/blinn-phong"), 12 * error(scene_with(square(0, 0)), "per-pixel/blinn-phong"));
}

TEST_F(NearUvsOnTheRenderer, OneFileMayHoldNearAndFarOnes) {
    const std::string text = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
                             "vt 1000000 -300000\nvt 1000001 -299999\nvt 1000000 -299999\n"
                             "f 1/1/1 2/2/1 3/3/1\nf 1/4/1 3/5/1 4/6/1\n";
    EXPECT_LE(error(scene_with(text), "per-pixel/blinn-phong"), 1e-4);
}

TEST_F(NearUvsOnTheRenderer, AWideTriangleKeepsItsBound) {
    for (const double span : {100.0, 1500.0, 20000.0}) {
        const double got = error(scene_with(square(7e5, -3e5, span)), "per-pixel/lambert");
        std::printf("%g repeats: %.2e of %.2e\n", span, got, bound(span));
        EXPECT_LE(got, bound(span));
    }
}

} // namespace
} // namespace sandbox
