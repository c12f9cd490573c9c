#include "reference/reference.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/feature_scenes.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// precision=medium: the GLSL that is drawn against its twin in half on the processor (reference/medium_stage.h).
namespace sandbox {
namespace {

constexpr Size size{96, 72};

class MediumStage : public GlTest {
  protected:
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
};

struct Agreement {
    std::size_t compared = 0, equal = 0, beyond_a_level = 0;
};

bool same(float drawn, double twin) {
    return drawn == static_cast<float>(twin) || (std::isnan(drawn) && std::isnan(twin));
}

/// Over the pixels that both see the same surface at.
Agreement agreement(const Frame &drawn, const ReferenceFrame &twin) {
    Agreement agreement;
    for (std::size_t i = 0; i < twin.color.size(); ++i) {
        if (twin.object_ids[i] == 0 || twin.object_ids[i] != drawn.object_ids[i] || twin.edge[i] != 0) {
            continue;
        }
        ++agreement.compared;
        double by = 0;
        bool equal = true;
        for (int channel = 0; channel < 3; ++channel) {
            const float shown = drawn.color.pixels[i][channel];
            if (!same(shown, twin.color[i][channel])) {
                equal = false;
                const double difference = std::abs(static_cast<double>(shown) - twin.color[i][channel]);
                by = std::isnan(difference) ? 1 : std::max(by, difference);
            }
        }
        agreement.equal += equal ? 1 : 0;
        agreement.beyond_a_level += by > 1.0 / 255 ? 1 : 0;
    }
    return agreement;
}

/// A varying's interpolation errs by a few units of float32 and now and then rounds to the next half: one of several
/// thousand varyings, and some twenty a pixel.
TEST_F(MediumStage, DrawsWhatItsTwinComputes) {
    const std::vector<std::string> techniques{"per-pixel/lambert:",
                                              "per-pixel/phong:",
                                              "per-pixel/blinn-phong:",
                                              "interpolated-vectors/lambert:",
                                              "interpolated-vectors/phong:",
                                              "interpolated-vectors/blinn-phong:",
                                              "hybrid/phong:",
                                              "hybrid/blinn-phong:",
                                              "per-pixel/phong:power=stable,",
                                              "per-pixel/blinn-phong:power=stable,",
                                              "per-pixel/phong:power=naive,",
                                              "per-pixel/blinn-phong:power=naive,",
                                              "per-pixel/phong:viewer=infinite,",
                                              "per-pixel/blinn-phong:viewer=infinite,",
                                              "per-pixel/phong:gate=none,",
                                              "per-pixel/blinn-phong:gate=view-facing,",
                                              "per-pixel/blinn-phong:gate=times-n-dot-l,normalisation=blinn-phong,",
                                              "per-pixel/blinn-phong:half_vector=constant,",
                                              "per-pixel/phong:ambient=where-lit,",
                                              "per-pixel/lambert:direction=unnegated-diffuse,",
                                              "per-pixel/phong:attenuation=interpolated,",
                                              "per-pixel/phong:attenuation=distance-interpolated,",
                                              "per-pixel/phong:normals=unnormalized,",
                                              "per-pixel/phong:renormalize=off,",
                                              "per-pixel/phong:facing=view,",
                                              "per-pixel/phong:position=w0,",
                                              "per-pixel/phong:position=absolute,"};
    std::vector<Scene> scenes = feature_scenes();
    scenes.push_back(open_scene("three-point-lights", Assets("assets"))); // lights with one term that fades
    for (const Scene &scene : scenes) {
        const auto resources = renderer_.resources().load(scene);
        const bool has_all = scene.name == "all" || scene.name == "two-sided"; // elsewhere the first few
        for (std::size_t i = 0; i < (has_all ? techniques.size() : 8); ++i) {
            const std::string &text = techniques[i];
            const Technique technique = parse_technique(text + "precision=medium");
            Frame drawn;
            try {
                drawn = renderer_.render(scene, technique, size, true);
            } catch (const InputError &) {
                continue; // too many varyings
            }
            const Agreement found = agreement(drawn, render_reference(scene, resources, technique, size));
            const auto compared = static_cast<double>(found.compared);
            EXPECT_GE(static_cast<double>(found.equal), 0.99 * compared) << scene.name << ", " << text;
            EXPECT_LE(static_cast<double>(found.beyond_a_level), 0.005 * compared) << scene.name << ", " << text;
        }
    }
}

} // namespace
} // namespace sandbox
