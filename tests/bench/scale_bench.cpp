#include "image/image.h"
#include "opponent.h"
#include "render/context.h"
#include "render/renderer.h"
#include "turns.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <glm/trigonometric.hpp>
#include <vector>

/// What a frame costs as a scene grows, one size after the other: lights, pixels, triangles; and what it takes to open
/// so many triangles. `order` is p of cost ~ size^p between a row and the row before it: 1 is linear.
namespace {

using namespace sandbox;

double milliseconds(const std::function<void()> &work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// The rows of one table: a size beside its costs.
class Table {
  public:
    Table(const char *size_name, std::vector<const char *> costs) : costs_(std::move(costs)) {
        std::printf("\n%12s", size_name);
        for (const char *cost : costs_) {
            std::printf(" | %26s  order", cost);
        }
        std::printf("\n");
    }
    void row(double size, const std::vector<Quartiles> &costs) {
        std::printf("%12.0f", size);
        for (std::size_t i = 0; i < costs.size(); ++i) {
            std::printf(" | %9.3f [%6.3f %6.3f] ", costs[i].median, costs[i].low, costs[i].high);
            if (before_.empty()) {
                std::printf("%6s", "");
            } else {
                std::printf("%6.2f", std::log(costs[i].median / before_[i].median) / std::log(size / size_before_));
            }
        }
        std::printf("\n");
        std::fflush(stdout);
        size_before_ = size;
        before_ = costs;
    }

  private:
    std::vector<const char *> costs_;
    double size_before_ = 0;
    std::vector<Quartiles> before_;
};

Quartiles frame_time(Renderer &renderer, const Scene &scene, const char *technique_text, Size size, int frames) {
    const Technique technique = parse_technique(technique_text);
    ScreenTarget target(size);
    std::vector<double> times;
    for (int frame = -2; frame < frames; ++frame) { // the first build and upload
        const double ms = milliseconds([&] {
            renderer.draw_shown(scene, technique, {}, target);
            target.finish();
        });
        if (frame >= 0) {
            times.push_back(ms);
        }
    }
    return quartiles(times);
}

constexpr const char *per_vertex = "per-vertex/blinn-phong", *per_pixel = "per-pixel/blinn-phong",
                     *automatic = "auto/blinn-phong";

Scene with_lights(int count) {
    Scene scene = three_lights_on_a_sphere();
    const Light light = scene.lights[0];
    scene.lights.clear();
    for (int i = 0; i < count; ++i) {
        const double turn = glm::radians(137.5) * i; // spread evenly
        scene.lights.push_back(light);
        scene.lights.back().position = {3 * std::cos(turn), 4.0 * (i + 0.5) / count - 2, 3 * std::sin(turn) + 2};
    }
    return scene;
}

} // namespace

int main(int argc, char **argv) {
    const int frames = argc > 1 ? std::atoi(argv[1]) : 15;
    const int most_rings = argc > 2 ? std::atoi(argv[2]) : 1581; // 10^7 triangles
    const auto context = Context::headless();
    std::printf("%s, %d frames a row, milliseconds [quartiles]\n", context->renderer().c_str(), frames);
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));

    Table lights("lights", {per_vertex, per_pixel, automatic});
    for (int count = 1; count <= 64; count *= 2) {
        const Scene scene = with_lights(count);
        lights.row(count, {frame_time(renderer, scene, per_vertex, {800, 600}, frames),
                           frame_time(renderer, scene, per_pixel, {800, 600}, frames),
                           frame_time(renderer, scene, automatic, {800, 600}, frames)});
    }
    Table pixels("pixels", {per_vertex, per_pixel});
    for (const Size size : {Size{480, 270}, Size{960, 540}, Size{1920, 1080}, Size{3840, 2160}}) {
        const Scene scene = three_lights_on_a_sphere();
        pixels.row(static_cast<double>(size.width) * size.height,
                   {frame_time(renderer, scene, per_vertex, size, frames),
                    frame_time(renderer, scene, per_pixel, size, frames)});
    }
    Table triangles("triangles", {"build and first frame", per_vertex, per_pixel, automatic});
    for (const int rings : {16, 50, 158, 500, 1581}) {
        if (rings > most_rings) {
            break;
        }
        Scene scene = three_lights_on_a_sphere();
        scene.objects[0].mesh = SphereShape{.radius = 1, .rings = rings, .segments = 2 * rings};
        std::vector<double> openings;
        for (int i = 0; i < 3; ++i) {
            Renderer fresh(Assets("assets"), ShaderParts(Assets("shaders")));
            ScreenTarget target({800, 600});
            openings.push_back(milliseconds([&] {
                fresh.draw_shown(scene, parse_technique(per_pixel), {}, target);
                target.finish();
            }));
        }
        triangles.row(4.0 * rings * (rings - 1),
                      {quartiles(openings), frame_time(renderer, scene, per_vertex, {800, 600}, frames),
                       frame_time(renderer, scene, per_pixel, {800, 600}, frames),
                       frame_time(renderer, scene, automatic, {800, 600}, frames)});
    }
    return 0;
}
