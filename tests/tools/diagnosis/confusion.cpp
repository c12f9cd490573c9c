// The confusion table of `diagnose`: every fault that shows in a scene, drawn as 8 bits, and what it is named as.
//   confusion FAULTS [SIZE [EVERY [PAIRS]]]
//     FAULTS 1 or 2; SIZE 320x240; EVERY: only each so-manieth fault [1]; PAIRS: "given" (default): frequency and
//     model are told; "searched": they are not
// Ten built-in scenes, per-vertex and per-pixel by Phong and Blinn-Phong.
// Build: ninja confusion. Run from anywhere; needs OpenGL 3.3 without a display.
#include "image/picture_size.h"
#include "render/context.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/diagnosed_faults.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fmt/format.h>
#include <string>

namespace sandbox {
namespace {

constexpr std::size_t most_scenes = 10;
constexpr const char *bases[]{"per-vertex/phong", "per-pixel/phong", "per-vertex/blinn-phong", "per-pixel/blinn-phong"};

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

int run(std::size_t faults, Size size, std::size_t every, bool searched) {
    const auto context = Context::headless();
    const Assets assets("assets");
    Renderer renderer(assets, ShaderParts(Assets("shaders")));
    const DiagnosisDraw draw = diagnosis_drawn_by(renderer);
    ConfusionTable table;
    double longest = 0;
    double longest_cpu = 0;
    double sum = 0;
    std::size_t asked = 0;
    auto names = builtin_scenes(assets);
    names.resize(std::min(names.size(), most_scenes));
    for (const std::string &name : names) {
        const Scene scene = open_scene(name, assets);
        for (const char *base : bases) {
            for (const FaultyPicture &picture :
                 faulty_pictures(name, scene, parse_technique(base), faults, draw, size, every)) {
                const auto start = std::chrono::steady_clock::now();
                const double cpu = cpu_seconds();
                const Diagnosis diagnosis = diagnose(
                    {picture.scene, picture.observed, searched ? std::nullopt : std::optional(picture.base), {}, {}},
                    draw);
                const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
                longest = std::max(longest, time.count());
                longest_cpu = std::max(longest_cpu, cpu_seconds() - cpu);
                sum += time.count();
                ++asked;
                table.add(picture, diagnosis);
                if (const Naming naming = naming_of(diagnosis, picture.truth);
                    naming == Naming::misnamed || naming == Naming::unknown) {
                    fmt::print("{} {}: {} {} ({:.3g} levels, {} pixels over)\n", name, to_string(picture.truth),
                               naming == Naming::unknown ? "unknown, nearest" : "misnamed",
                               to_string(diagnosis.technique), diagnosis.residual.largest, diagnosis.residual.over);
                }
            }
        }
    }
    fmt::print("{}{} pictures; {:.2f} s each, longest {:.2f} s ({:.2f} s of CPU)\n", table.text(), asked,
               sum / static_cast<double>(asked), longest, longest_cpu);
    return table.count(Naming::misnamed) == 0 ? 0 : 1;
}

} // namespace
} // namespace sandbox

int main(int argc, char **argv) {
    const auto argument = [&](int i, const char *otherwise) { return std::string(i < argc ? argv[i] : otherwise); };
    return sandbox::run(argument(1, "1") == "2" ? 2 : 1, sandbox::parse_size(argument(2, "320x240")),
                        std::stoul(argument(3, "1")), argument(4, "given") == "searched");
}
