#include "scene/resources.h"
#include "scene/scene_file.h"
#include "shading/prepared_object.h"
#include "shading/program_source.h"

#include <benchmark/benchmark.h>

namespace sandbox {
namespace {

/// From scene and technique to both texts, as before every draw of a program not seen yet. Must stay under 1 ms.
void assemble_program(benchmark::State &state, const char *scene_name, const char *technique_text) {
    const Assets assets("assets");
    const ShaderParts parts(Assets("shaders"));
    const Scene scene = open_scene(scene_name, assets);
    const Technique technique = parse_technique(technique_text);
    const auto resources = Resources(assets).load(scene);
    for (auto _ : state) {
        const PreparedObject object = prepare_object(scene, technique, scene.objects[0], *resources[0].mesh);
        benchmark::DoNotOptimize(assemble(object.program, parts));
    }
}
BENCHMARK_CAPTURE(assemble_program, three_point_lights, "three-point-lights", "per-pixel/blinn-phong")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assemble_program, spot_vectors, "spot-light", "interpolated-vectors/phong")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assemble_program, full, "three-point-lights", "per-pixel/phong:program=full")
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace sandbox

BENCHMARK_MAIN();
