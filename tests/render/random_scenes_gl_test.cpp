#include "image/image_file.h"
#include "measure/metrics/metrics.h"
#include "render/renderer.h"
#include "shading/features.h"
#include "tools/gl_test.h"
#include "tools/random_scene.h"
#include "tools/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

/// Random scenes under random techniques, faults and all: OpenGL's picture against the same technique in double.
/// A failure names its seed; SANDBOX_SEED=N runs that one scene alone.
namespace sandbox {
namespace {

constexpr Size size{64, 64};
constexpr unsigned scenes = 60;
constexpr unsigned techniques_a_scene = 4;

/// Powers that are raised the textbook way: the largest n in the scene.
double textbook_exponent(const Scene &scene, const Technique &technique) {
    double n = 0;
    for (const Object &object : scene.objects) {
        const double raised =
            technique.model == Model::lambert ? 0 : raised_exponent(scene, technique.model, object.material);
        const bool stable =
            technique.renormalize == Renormalize::on &&
            (technique.power == Power::stable || (technique.power == Power::automatic && raised >= stable_power_from));
        n = std::max(n, stable ? 0 : raised);
    }
    return n;
}

double brightest(const ReferenceFrame &frame) {
    double most = 1;
    for (const glm::dvec3 &color : frame.color) {
        most = std::max({most, color.x, color.y, color.z});
    }
    return most;
}

/// Every other texel of every other row.
ByteImage halved(const Image &image) {
    Image half({image.size.width / 2, image.size.height / 2});
    for (int y = 0; y < half.size.height; ++y) {
        for (int x = 0; x < half.size.width; ++x) {
            half.pixels[half.index(x, y)] = image.pixels[image.index(2 * x, 2 * y)];
        }
    }
    return to_display(half, Display::linear);
}

class RandomScenes : public GlTest {
  protected:
    /// Softpipe reads a texture by tiles of 32 x 32 texels, kept in 16 places by (x + 9 y) mod 16. Where four texels
    /// are filtered that lie in four tiles, at the seam of a repeated 256 x 256 texture two of the tiles have one
    /// place, and it reads the wrong tile's texel: errors of 3e-3 in one pixel, to the digit what such a cache gives.
    /// Of 128 x 128 texels no four neighbouring tiles share a place.
    Scene as_the_driver_can(Scene scene) {
        if (context().renderer().find("softpipe") == std::string::npos) {
            return scene;
        }
        for (Object &object : scene.objects) {
            std::string &texture = object.material.texture;
            if (!texture.empty()) {
                const std::string bytes = Assets("assets").read("textures/" + texture).value();
                folder_.write(texture, encode_png(halved(decode_image(bytes, texture))));
                texture = folder_.path() / texture;
            }
        }
        return scene;
    }

    /// Returns the largest difference as a share of its bound: 2e-5 + 4e-7 n as everywhere, 3e-5 more for colours that
    /// are interpolated over slivers (truth_gl_test.cpp), all relative to the brightest pixel where that is above 1.
    double expect_truth(const Scene &scene, const Technique &technique, const std::string &name) {
        const ReferenceFrame truth = render_reference(scene, renderer_.resources().load(scene), technique, size);
        const Metrics metrics = compare(renderer_.render(scene, technique, size, true), truth);
        const double bound = (5e-5 + 4e-7 * textbook_exponent(scene, technique)) * brightest(truth);
        EXPECT_EQ(metrics.nonfinite_pixels, 0U) << name;
        EXPECT_LE(metrics.norms.max_abs, bound) << name;
        EXPECT_LE(metrics.silhouette_pixels, 4U) << name;
        compared_ += metrics.compared_pixels;
        left_out_ += metrics.silhouette_pixels + metrics.edge_pixels + metrics.jump_pixels + metrics.rounding_pixels;
        return metrics.norms.max_abs / bound;
    }

    TemporaryFolder folder_;
    std::size_t compared_ = 0;
    std::size_t left_out_ = 0;
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

TEST_F(RandomScenes, DrawWhatTheTruthDraws) {
    const char *only = std::getenv("SANDBOX_SEED");
    double worst = 0;
    std::string worst_name;
    for (unsigned seed = 0; seed < scenes; ++seed) {
        if (only != nullptr && std::atoi(only) != static_cast<int>(seed)) {
            continue;
        }
        const Scene scene = as_the_driver_can(random_scene(seed));
        for (unsigned i = 0; i < techniques_a_scene; ++i) {
            const Technique technique = random_technique(1000 * seed + i);
            const std::string name = "SANDBOX_SEED=" + std::to_string(seed) + " " + to_string(technique);
            const double of_bound = expect_truth(scene, technique, name);
            if (of_bound > worst) {
                worst = of_bound;
                worst_name = name;
            }
        }
    }
    std::printf("%zu pixels compared, %zu at edges and jumps left out; worst %.2f of its bound: %s\n", compared_,
                left_out_, worst, worst_name.c_str());
    EXPECT_LT(static_cast<double>(left_out_), 0.05 * static_cast<double>(compared_));
}

/// Nothing but a highlight is left for hybrid to compute, on a texture that must not tint it.
TEST_F(RandomScenes, AHighlightAloneUnderHybridIsNotTinted) {
    Scene scene;
    scene.objects = {{"ball", SphereShape{1.5, 16, 24}, {}, {}, false}};
    scene.objects[0].material.texture = "marble.png";
    scene.objects[0].material.texture_modulates_specular = false;
    scene.lights.resize(2);
    scene.lights[0].position = {3, 3, 3};
    scene.lights[1].position = {-3, 2, 4};
    for (Light &light : scene.lights) {
        light.diffuse = 0;
    }
    scene = as_the_driver_can(scene);
    expect_truth(scene, parse_technique("hybrid/blinn-phong"), "a highlight alone, hybrid/blinn-phong");
    expect_truth(scene, parse_technique("hybrid/phong"), "a highlight alone, hybrid/phong");
}

} // namespace
} // namespace sandbox
