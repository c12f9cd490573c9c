#include "measure/metrics/metrics.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/gl_test.h"

#include <algorithm>
#include <string>

/// The frequency `auto`, drawn.
namespace sandbox {
namespace {

class AutomaticGl : public GlTest {
  protected:
    static Scene scene_named(const std::string &name) { return open_scene(name, Assets("assets")); }
    Renderer renderer_{Assets("assets"), ShaderParts(Assets("shaders"))};
    const Size size_{320, 240};
};

Technique technique_of(Frequency frequency, Model model, Program program = Program::specialised) {
    return {.frequency = frequency, .model = model, .program = program};
}

/// The promise itself, float32 included: beside per-pixel in double. Masked pixels are nobody's error.
TEST_F(AutomaticGl, KeepsItsPromiseBesideDoublePerPixel) {
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const Scene scene = scene_named(name);
        const auto loaded = renderer_.resources().load(scene);
        for (const Model model : {Model::lambert, Model::phong, Model::blinn_phong}) {
            const ReferenceFrame truth =
                render_reference(scene, loaded, technique_of(Frequency::per_pixel, model), size_);
            for (const Program program : {Program::specialised, Program::baked, Program::full}) {
                const Technique technique = technique_of(Frequency::automatic, model, program);
                const Metrics metrics = compare(renderer_.render(scene, technique, size_, true), truth, Flip::without);
                EXPECT_LE(metrics.norms.max_abs, technique.tolerance) << name << ", " << to_string(technique);
            }
        }
    }
}

/// Two programs draw triangles that share edges: no pixel between them is missed, drawn twice in front or lost.
TEST_F(AutomaticGl, ShowsTheSameSurfacesAsPerPixel) {
    std::size_t cheap = 0;
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        const Scene scene = scene_named(name);
        const Frame automatic =
            renderer_.render(scene, technique_of(Frequency::automatic, Model::blinn_phong), size_, true);
        const Frame per_pixel =
            renderer_.render(scene, technique_of(Frequency::per_pixel, Model::blinn_phong), size_, true);
        EXPECT_EQ(automatic.object_ids, per_pixel.object_ids) << name;
        for (std::size_t i = 0; i < automatic.color.pixels.size(); ++i) {
            cheap += automatic.color.pixels[i] != per_pixel.color.pixels[i] ? 1U : 0U;
        }
    }
    EXPECT_GT(cheap, 10000U) << "or nothing was lit per vertex";
}

/// A window chooses aside: the picture of a choice that was brought is that of one's own.
TEST_F(AutomaticGl, DrawsByAChoiceMadeElsewhere) {
    const Scene scene = scene_named("vase");
    const Technique automatic = technique_of(Frequency::automatic, Model::blinn_phong);
    const Image own = renderer_.render(scene, automatic, size_).color;
    Renderer other(Assets("assets"), ShaderParts(Assets("shaders")));
    const std::vector<ObjectResources> objects = other.unchosen(scene, automatic, size_);
    ASSERT_EQ(objects.size(), scene.objects.size());
    EXPECT_TRUE(other.unchosen(scene, technique_of(Frequency::per_pixel, Model::blinn_phong), size_).empty());
    other.take_choice(scene, automatic, size_, objects,
                      certificate::choose(scene, objects, automatic, aspect_of(size_)));
    EXPECT_TRUE(other.unchosen(scene, automatic, size_).empty());
    EXPECT_FALSE(other.unchosen(scene, automatic, {size_.height, size_.width}).empty()) << "another aspect";
    EXPECT_EQ(other.render(scene, automatic, size_).color.pixels == own.pixels, true);
}

/// Or frames that a report times in turns would hold the choosing.
TEST_F(AutomaticGl, EveryChoiceStaysWhileAllIsKept) {
    const Technique automatic = technique_of(Frequency::automatic, Model::blinn_phong);
    std::vector<Scene> scenes;
    for (int i = 0; i < 70; ++i) {
        scenes.push_back(scene_named("directional-light"));
        scenes.back().objects[0].material.shininess = 10 + i;
    }
    std::shared_ptr<const void> kept = renderer_.keep_all();
    Target target(size_);
    const auto unchosen = [&] {
        return std::ranges::count_if(
            scenes, [&](const Scene &scene) { return !renderer_.unchosen(scene, automatic, size_).empty(); });
    };
    for (const Scene &scene : scenes) {
        renderer_.draw(scene, automatic, target);
    }
    EXPECT_EQ(unchosen(), 0);
    kept.reset();
    renderer_.draw(scenes.back(), automatic, target);
    EXPECT_GT(unchosen(), 0);
    EXPECT_TRUE(renderer_.unchosen(scenes.back(), automatic, size_).empty());
}

/// Stripes lie where vertices are lit, and nowhere under another frequency.
TEST_F(AutomaticGl, StripesLieOnWhatIsLitPerVertex) {
    const Scene scene = scene_named("vase");
    const Technique automatic = technique_of(Frequency::automatic, Model::blinn_phong);
    const Technique per_pixel = technique_of(Frequency::per_pixel, Model::blinn_phong);
    const auto stripes = [&](const Technique &technique) {
        Target target(size_);
        renderer_.draw(scene, technique, target);
        const Image before = target.read_color();
        renderer_.draw_overlays(scene, technique, {.proved = true}, target);
        const Image after = target.read_color();
        std::vector<std::size_t> changed;
        for (std::size_t i = 0; i < after.pixels.size(); ++i) {
            if (after.pixels[i] != before.pixels[i]) {
                changed.push_back(i);
            }
        }
        return changed;
    };
    EXPECT_TRUE(stripes(per_pixel).empty());
    const std::vector<std::size_t> striped = stripes(automatic);
    EXPECT_GT(striped.size(), 100U);
    const Image smooth = renderer_.render(scene, per_pixel, size_).color;
    const Image drawn = renderer_.render(scene, automatic, size_).color;
    const Image vertices =
        renderer_.render(scene, technique_of(Frequency::per_vertex, Model::blinn_phong), size_).color;
    const auto lit_per_vertex = std::ranges::count_if(striped, [&](std::size_t i) {
        return drawn.pixels[i] == vertices.pixels[i] || drawn.pixels[i] != smooth.pixels[i];
    });
    // Lifted off the surface by a tenth of a pixel, a stripe may show beyond an edge.
    EXPECT_GT(static_cast<double>(lit_per_vertex), 0.97 * static_cast<double>(striped.size()));
}

} // namespace
} // namespace sandbox
