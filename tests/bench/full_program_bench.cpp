#include "render/context.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "turns.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <glm/common.hpp>

namespace {

double largest_difference(const sandbox::Image &a, const sandbox::Image &b) {
    float largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto d = glm::abs(a.pixels[i] - b.pixels[i]);
        largest = std::max({largest, d.r, d.g, d.b});
    }
    return static_cast<double>(largest);
}

} // namespace

/// What leaving out saves: for every built-in scene, the program that can do every scene against the one made for it.
int main(int argc, char **argv) {
    using namespace sandbox;
    const int turns = argc > 1 ? std::atoi(argv[1]) : 21;
    constexpr Size size{800, 600};
    const auto context = Context::headless();
    std::printf("%s, %dx%d, %d turns of 10 frames\n", context->renderer().c_str(), size.width, size.height, turns);
    const Assets assets("assets");
    Renderer renderer(assets, ShaderParts(Assets("shaders")));
    Target target(size);
    for (const auto &name : builtin_scenes(assets)) {
        const Scene scene = open_scene(name, assets);
        for (const char *text : {"per-vertex/blinn-phong", "per-pixel/blinn-phong"}) {
            Technique technique = parse_technique(text);
            const auto draw = [&](Program program) {
                technique.program = program;
                renderer.draw(scene, technique, target);
                target.finish();
            };
            const Contender full{name + " " + text + " full", [&] { draw(Program::full); }};
            const Contender specialised{"specialised", [&] { draw(Program::specialised); }};
            const Duel duel = take_turns(full, specialised, turns);
            full.frame();
            const Image general = target.read_color();
            specialised.frame();
            char note[64];
            std::snprintf(note, sizeof note, " | max difference %.1e",
                          largest_difference(general, target.read_color()));
            print_duel(full, specialised, duel, note);
        }
    }
    return 0;
}
