// What pictures are diagnosed as: the confusion table of `diagnose`, and whether right shaders are accused.
//   confusion single|pairs|conventions|rewrites [SIZE [EVERY [given|searched]]]
//     single, pairs: every fault that shows in a scene, or two, drawn as 8 bits
//     conventions: every fault that shows, with each way to write numbers otherwise and each other light
//     rewrites: own shading that is right, written in 1000 ways
//     SIZE 320x240; EVERY: only each so-manieth [1]; given: frequency and model are told, or searched
// Ten built-in scenes, per-vertex and per-pixel by Phong and Blinn-Phong.
// Build: ninja confusion. Run from anywhere; needs OpenGL 3.3 without a display.
#include "image/picture_size.h"
#include "render/context.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/diagnosed_faults.h"
#include "tools/own_rewrites.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <string>

namespace sandbox {
namespace {

constexpr std::size_t most_scenes = 10;
constexpr const char *bases[]{"per-vertex/phong", "per-pixel/phong", "per-vertex/blinn-phong", "per-pixel/blinn-phong"};
constexpr std::uint32_t most_rewrites = 1000;

struct Flags {
    std::string kind;
    Size size;
    std::size_t every;
    bool searched;
};

/// How long diagnoses take.
class Times {
  public:
    template <class Work> auto measured(const std::string &what, Work work) {
        const auto start = std::chrono::steady_clock::now();
        const double cpu = cpu_seconds();
        auto result = work();
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        if (time.count() > longest_) {
            longest_ = time.count();
            longest_cpu_ = cpu_seconds() - cpu;
            longest_what_ = what;
        }
        sum_ += time.count();
        ++count_;
        return result;
    }
    void print() const {
        fmt::print("{} pictures; {:.2f} s each, longest {:.2f} s ({:.2f} s of CPU): {}\n", count_,
                   sum_ / static_cast<double>(count_), longest_, longest_cpu_, longest_what_);
    }

  private:
    static double cpu_seconds() {
        timespec now{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }
    double longest_ = 0, longest_cpu_ = 0, sum_ = 0;
    std::size_t count_ = 0;
    std::string longest_what_;
};

struct Tool {
    Flags flags;
    Assets assets{"assets"};
    Renderer renderer{assets, ShaderParts(Assets("shaders"))};
    DiagnosisDraw draw = diagnosis_drawn_by(renderer);
    Times times{};

    int confuse() {
        ConfusionTable table;
        auto names = builtin_scenes(assets);
        names.resize(std::min(names.size(), most_scenes));
        for (const std::string &name : names) {
            const Scene scene = open_scene(name, assets);
            for (const char *base : bases) {
                for (const FaultyPicture &picture : pictures(name, scene, parse_technique(base))) {
                    add(picture, table);
                }
            }
        }
        fmt::print("{}", table.text());
        times.print();
        return table.count(Naming::misnamed) == 0 ? 0 : 1;
    }

    int rewrite() {
        std::size_t accused = 0;
        std::size_t masked = 0;
        std::size_t seconds = 0;
        for (std::uint32_t seed = 0; seed < most_rewrites; seed += static_cast<std::uint32_t>(flags.every)) {
            const OwnRewrite rewrite = own_rewrite(seed);
            const std::string words = fmt::format("{} {} {}", seed, rewrite.scene_name, to_string(rewrite.truth));
            const Diagnosis diagnosis = times.measured(words, [&] { return diagnosis_of(rewrite, draw, flags.size); });
            masked += diagnosis.masked ? 1 : 0;
            seconds += diagnosis.after_proposal ? 1 : 0;
            if (is_accused(diagnosis, rewrite)) {
                ++accused;
                fmt::print("{}: {} {}, {:.3g} levels, {} pixels{}\n", words,
                           verdict_words[static_cast<std::size_t>(diagnosis.verdict)], to_string(diagnosis.technique),
                           diagnosis.residual.largest, diagnosis.residual.over,
                           diagnosis.proposal ? "; proposed: " + diagnosis.proposal->arguments : "");
            }
        }
        fmt::print("accused: {}; right beside edges and jumps only: {}; drawn in a second scene, too: {}\n", accused,
                   masked, seconds);
        times.print();
        return accused == 0 ? 0 : 1;
    }

  private:
    std::vector<FaultyPicture> pictures(const std::string &name, const Scene &scene, const Technique &base) {
        if (flags.kind == "conventions") {
            return unconventional_pictures(name, scene, base, draw, flags.size, flags.every);
        }
        return faulty_pictures(name, scene, base, flags.kind == "pairs" ? 2 : 1, draw, flags.size, flags.every);
    }

    void add(const FaultyPicture &picture, ConfusionTable &table) {
        DiagnosisRequest request{picture.scene, picture.observed, picture.base, {}, {}};
        if (flags.searched) {
            request.technique.reset();
        }
        request.trials = {trial_scenes(picture.scene, picture.scene_name, assets)};
        request.redraw = [&](const Scene &other) { return drawn_as_bytes(draw, other, picture.truth, flags.size); };
        const std::string words = picture.scene_name + " " + truth_of(picture);
        const Diagnosis diagnosis = times.measured(words, [&] { return diagnose(request, draw); });
        table.add(picture, diagnosis);
        const Naming naming = naming_of(diagnosis, picture);
        if (naming == Naming::misnamed || naming == Naming::unknown) {
            fmt::print("{}: {} {}, {:.3g} levels, {} pixels over\n", words,
                       naming == Naming::unknown ? "unknown, nearest" : "misnamed", name_of(diagnosis),
                       diagnosis.residual.largest, diagnosis.residual.over);
        }
    }
};

} // namespace
} // namespace sandbox

int main(int argc, char **argv) {
    const auto argument = [&](int i, const char *otherwise) { return std::string(i < argc ? argv[i] : otherwise); };
    const auto context = sandbox::Context::headless();
    sandbox::Tool tool{{argument(1, "single"), sandbox::parse_size(argument(2, "320x240")),
                        std::stoul(argument(3, "1")), argument(4, "given") == "searched"}};
    return tool.flags.kind == "rewrites" ? tool.rewrite() : tool.confuse();
}
