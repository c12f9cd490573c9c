// How fast the truth is: linear in pixels and in lights, near constant in triangles until they are smaller than pixels.
#include "reference/reference.h"

#include "measure/metrics/flip.h"
#include "scene/mesh.h"

#include <benchmark/benchmark.h>

namespace {

using namespace sandbox;

/// A ball that fills the picture's height, 4 rings^2 triangles, under point lights.
Scene ball(int rings, int lights) {
    Scene scene;
    scene.camera.position = {0, 0, 2.8};
    Object object;
    object.mesh = SphereShape{1, rings, 2 * rings};
    scene.objects.push_back(object);
    for (int i = 0; i < lights; ++i) {
        Light light;
        light.position = {i % 3 - 1, 2, 4 - i % 5};
        light.attenuation = {0.2, 0.1, 0.1};
        scene.lights.push_back(light);
    }
    return scene;
}

void draw(benchmark::State &state, const Scene &scene, const Technique &technique, Size size,
          Surface surface = Surface::mesh) {
    const std::vector<ObjectResources> resources{
        {std::make_shared<const Mesh>(build_mesh(scene.objects[0].mesh)), nullptr}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(render_reference(scene, resources, technique, size, surface));
    }
}

void pixels(benchmark::State &state) {
    const int height = static_cast<int>(state.range(0));
    draw(state, ball(64, 3), {}, {height * 16 / 9, height});
}
void lights(benchmark::State &state) { draw(state, ball(64, static_cast<int>(state.range(0))), {}, {1280, 720}); }
void rings(benchmark::State &state) { draw(state, ball(static_cast<int>(state.range(0)), 3), {}, {1280, 720}); }
void frequencies(benchmark::State &state) {
    Technique technique;
    technique.frequency = static_cast<Frequency>(state.range(0));
    draw(state, ball(64, 3), technique, {1280, 720});
}
void analytic(benchmark::State &state) { draw(state, ball(64, 3), {}, {1280, 720}, Surface::analytic); }

void flip_720p(benchmark::State &state) {
    ByteImage one{{1280, 720}, std::vector<std::uint8_t>(std::size_t{1280} * 720 * 3)};
    ByteImage other = one;
    for (std::size_t i = 0; i < one.rgb.size(); ++i) {
        one.rgb[i] = static_cast<std::uint8_t>(i * 37 % 251);
        other.rgb[i] = static_cast<std::uint8_t>(i * 41 % 241);
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(mean_flip(one, other));
    }
}

BENCHMARK(pixels)->Arg(180)->Arg(360)->Arg(720)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(lights)->Arg(1)->Arg(3)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(rings)->Arg(8)->Arg(64)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(frequencies)->DenseRange(0, 4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(analytic)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(flip_720p)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
