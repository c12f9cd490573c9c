#include "certificate/choice.h"
#include "reference/reference.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

/// The truth of the frequency `auto`.
namespace sandbox {
namespace {

struct Pictures {
    ReferenceFrame automatic, per_vertex, per_pixel;
};
Pictures pictures(const std::string &name, Technique technique, Size size) {
    const Assets assets("assets");
    const Scene scene = open_scene(name, assets);
    const auto loaded = Resources(assets).load(scene);
    const auto drawn = [&](Frequency frequency) {
        technique.frequency = frequency;
        return render_reference(scene, loaded, technique, size);
    };
    return {drawn(Frequency::automatic), drawn(Frequency::per_vertex), drawn(Frequency::per_pixel)};
}

double largest(const glm::dvec3 &a, const glm::dvec3 &b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// Every pixel is one of the two, to the bit, and no farther from per-pixel than promised.
TEST(Automatic, IsPerVertexOrPerPixelAndKeepsItsPromise) {
    for (const char *name : {"vase", "studio", "directional-light"}) {
        for (const Model model : {Model::lambert, Model::phong, Model::blinn_phong}) {
            for (const double tolerance : {1.0 / 255, 0.02}) {
                const auto [automatic, per_vertex, per_pixel] =
                    pictures(name, {.model = model, .tolerance = tolerance}, {160, 120});
                std::size_t cheap = 0;
                for (std::size_t i = 0; i < automatic.color.size(); ++i) {
                    const bool differs = per_vertex.color[i] != per_pixel.color[i];
                    ASSERT_TRUE(automatic.color[i] == per_vertex.color[i] || automatic.color[i] == per_pixel.color[i]);
                    cheap += differs && automatic.color[i] == per_vertex.color[i] ? 1U : 0U;
                    EXPECT_LE(largest(automatic.color[i], per_pixel.color[i]), tolerance) << name;
                }
                EXPECT_GT(cheap, automatic.color.size() / 100) << name << ": or nothing was tried";
            }
        }
    }
}

} // namespace
} // namespace sandbox
