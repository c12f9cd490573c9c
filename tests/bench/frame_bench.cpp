#include "opponent.h"
#include "render/context.h"
#include "render/renderer.h"
#include "turns.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

/// Our frame against programs written by hand, same triangles, same lights, same equation, same kind of target; and
/// what lighting costs at all: one directional Lambert light per pixel against the same triangles in one colour.
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

int largest_difference(const ByteImage &ours, const std::vector<unsigned char> &theirs) {
    int largest = 0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        largest = std::max(largest, std::abs(ours.rgb[i] - theirs[i]));
    }
    return largest;
}

void duel(Renderer &renderer, const Scene &scene, const char *technique_text, const Opponent::Kind &kind,
          const char *rival, int turns) {
    const Technique technique = parse_technique(technique_text);
    const Opponent opponent(scene, kind, size);
    const bool bytes = kind.pixels == Opponent::Pixels::bytes;
    Target light(size);
    ScreenTarget screen(size);
    const Contender ours{technique_text, [&] {
                             if (bytes) {
                                 renderer.draw_shown(scene, technique, {}, screen);
                                 screen.finish();
                             } else {
                                 renderer.draw(scene, technique, light);
                                 light.finish();
                             }
                         }};
    const Contender theirs{rival, [&] { opponent.frame(); }};
    const Duel result = take_turns(ours, theirs, turns);
    char note[64] = "";
    if (kind.shading == Opponent::Shading::constant_colour) {
        // another picture
    } else if (bytes) {
        const ByteImage picture = read_window_surface(screen.framebuffer(), size);
        std::snprintf(note, sizeof note, " | 8 bits, max difference %d",
                      largest_difference(picture, opponent.read_bytes()));
    } else {
        std::snprintf(note, sizeof note, " | max difference %.1e",
                      largest_difference(light.read_color(), opponent.read_rgba()));
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
    using Writing = Opponent::Writing;
    using Shading = Opponent::Shading;
    using Pixels = Opponent::Pixels;
    constexpr auto phong = Opponent::Highlight::phong, blinn_phong = Opponent::Highlight::blinn_phong;
    const struct {
        const char *technique;
        Opponent::Kind kind;
        const char *rival;
    } rows[] = {
        {"per-vertex/phong", {Writing::textbook, Shading::per_vertex, phong, Pixels::light}, "textbook"},
        {"per-vertex/blinn-phong", {Writing::textbook, Shading::per_vertex, blinn_phong, Pixels::light}, "textbook"},
        {"per-pixel/phong", {Writing::textbook, Shading::per_pixel, phong, Pixels::light}, "textbook"},
        {"per-pixel/blinn-phong", {Writing::textbook, Shading::per_pixel, blinn_phong, Pixels::light}, "textbook"},
        {"per-vertex/blinn-phong", {Writing::plain, Shading::per_vertex, blinn_phong, Pixels::light}, "plain"},
        {"per-pixel/blinn-phong", {Writing::plain, Shading::per_pixel, blinn_phong, Pixels::light}, "plain"},
        {"per-vertex/blinn-phong", {Writing::plain, Shading::per_vertex, blinn_phong, Pixels::bytes}, "plain"},
        {"per-pixel/blinn-phong", {Writing::plain, Shading::per_pixel, blinn_phong, Pixels::bytes}, "plain"},
        {"per-vertex/blinn-phong", {Writing::lean, Shading::per_vertex, blinn_phong, Pixels::bytes}, "lean"},
        {"per-pixel/blinn-phong", {Writing::lean, Shading::per_pixel, blinn_phong, Pixels::bytes}, "lean"},
        {"per-vertex/blinn-phong:program=baked",
         {Writing::plain, Shading::per_vertex, blinn_phong, Pixels::bytes},
         "plain"},
        {"per-pixel/blinn-phong:program=baked",
         {Writing::plain, Shading::per_pixel, blinn_phong, Pixels::bytes},
         "plain"},
        {"per-vertex/blinn-phong:program=baked",
         {Writing::lean, Shading::per_vertex, blinn_phong, Pixels::bytes},
         "lean"},
        {"per-pixel/blinn-phong:program=baked",
         {Writing::lean, Shading::per_pixel, blinn_phong, Pixels::bytes},
         "lean"},
    };
    for (const auto &row : rows) {
        duel(renderer, three, row.technique, row.kind, row.rival, turns);
    }
    const Opponent::Kind constant{.shading = Shading::constant_colour};
    duel(renderer, one_directional_light(), "per-pixel/lambert", constant, "one colour", turns);
    return 0;
}
