#include "render/context.h"
#include "render/renderer.h"
#include "textbook.h"
#include "turns.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

/// Our frame against a textbook's hand-written program, same triangles, same lights, same equation; and what lighting
/// costs at all: one directional Lambert light per pixel against the same triangles in one colour.
namespace {

using namespace sandbox;
constexpr Size size{800, 600};

double largest_difference(const Image &ours, const std::vector<float> &theirs) {
    double largest = 0;
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float value = theirs[4 * ((height - 1 - y) * width + x) + static_cast<std::size_t>(c)];
                largest = std::max(largest, static_cast<double>(std::abs(ours.pixels[y * width + x][c] - value)));
            }
        }
    }
    return largest;
}

void duel(Renderer &renderer, const Scene &scene, const char *technique_text, const Textbook &textbook, int turns,
          const char *rival, bool compare) {
    const Technique technique = parse_technique(technique_text);
    Target target(size);
    const Contender ours{technique_text, [&] {
                             renderer.draw(scene, technique, target);
                             Renderer::finish();
                         }};
    const Contender theirs{rival, [&] { textbook.frame(); }};
    const Duel result = take_turns(ours, theirs, turns);
    char note[64] = "";
    if (compare) {
        std::snprintf(note, sizeof note, " | max difference %.1e",
                      largest_difference(target.read_color(), textbook.read_rgba()));
    }
    print_duel(ours, theirs, result, note);
}

} // namespace

int main(int argc, char **argv) {
    const int turns = argc > 1 ? std::atoi(argv[1]) : 31;
    const auto context = Context::headless();
    std::printf("%s, %dx%d, %d turns of 10 frames\n", context->renderer().c_str(), size.width, size.height, turns);
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    const Scene three = three_lights_on_a_sphere();
    using Shading = Textbook::Shading;
    using Highlight = Textbook::Highlight;
    const struct {
        const char *technique;
        Shading shading;
        Highlight highlight;
    } rows[] = {{"per-vertex/phong", Shading::per_vertex, Highlight::phong},
                {"per-vertex/blinn-phong", Shading::per_vertex, Highlight::blinn_phong},
                {"per-pixel/phong", Shading::per_pixel, Highlight::phong},
                {"per-pixel/blinn-phong", Shading::per_pixel, Highlight::blinn_phong}};
    for (const auto &row : rows) {
        const Textbook textbook(three, row.shading, row.highlight, size);
        duel(renderer, three, row.technique, textbook, turns, "textbook", true);
    }
    const Scene sun = one_directional_light();
    const Textbook constant(sun, Shading::constant_colour, Highlight::phong, size);
    duel(renderer, sun, "per-pixel/lambert", constant, turns, "one colour", false);
    return 0;
}
