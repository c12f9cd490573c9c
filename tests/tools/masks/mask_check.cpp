// Which pixels are left out of error figures, over every scene there is, and whether that is owed.
//   mask_check list            every row with a mask over 2 % of what it shows, by cause, with the largest error under
//   it;
//                              of those over 10 %, an independent check: 16 samples a pixel, drawn against reference;
//                              and whether what jumps or cannot be told foretells the largest errors that it hides
//   mask_check scene SEED      prints the technique and the scene of a seed
//   mask_check search [FIRST [COUNT [SECONDS]]]
//                              spiteful scenes: masks that hide a fault, that cover what is right, that are missing
// Build: ninja mask_check. Run from anywhere; needs OpenGL 3.3 without a display.
#include "image/error.h"
#include "measure/metrics/metrics.h"
#include "measure/stability/cases.h"
#include "render/context.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/conditioning.h"
#include "tools/feature_scenes.h"
#include "tools/masks/owed.h"
#include "tools/masks/spiteful_scenes.h"
#include "tools/random_scene.h"
#include "tools/stress_scenes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <ranges>
#include <string>

namespace sandbox {
namespace {

constexpr Size size{96, 96};
constexpr int side = 4; ///< 16 samples a pixel
constexpr double listed_share = 0.02, checked_share = 0.1;
constexpr double level = 1.0 / 255; ///< of the brightest value where that is above 1
constexpr double change = 1e-6;     ///< from which on masks take a jump for one

double largest(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double brightest(const ReferenceFrame &frame) {
    double most = 1;
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        most = std::max(most, frame.object_ids[i] != 0 ? largest(frame.color[i]) : 0);
    }
    return most;
}

std::size_t shown_pixels(const Metrics &metrics) {
    std::size_t shown = metrics.compared_pixels;
    for (const Mask &mask : masks) {
        shown += metrics.*mask.pixels;
    }
    return shown;
}

/// Is every error of more than `bound` under the masks of jumps and rounding one that the reference foretells: at most
/// what jumps there, or all that depends on the direction that is lost? Asks at the `asked` largest errors.
bool foretold(const Frame &drawn, const ReferenceFrame &truth, const Scene &scene,
              const std::vector<ObjectResources> &resources, const Technique &technique, double bound) {
    constexpr std::size_t asked = 12;
    const std::vector<PixelUse> uses = pixel_uses(drawn.object_ids, truth);
    const auto error = [&](std::size_t i) { return largest(glm::dvec3(drawn.color.pixels[i]) - truth.color[i]); };
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if ((uses[i] == PixelUse::jump || uses[i] == PixelUse::rounding) && !(error(i) <= bound)) {
            wrong.push_back(i);
        }
    }
    std::ranges::sort(wrong, std::ranges::greater(), error);
    wrong.resize(std::min(wrong.size(), asked));
    return std::ranges::all_of(wrong, [&](std::size_t i) {
        const auto width = static_cast<std::size_t>(size.width);
        const auto probe =
            probe_pixel(scene, resources, technique, size, static_cast<int>(i % width), static_cast<int>(i / width));
        return probe && error(i) <= probe->doubt + bound;
    });
}

class Checker16 {
  public:
    explicit Checker16(Renderer &renderer) : renderer_(renderer) {}

    /// The largest difference of two pictures of 16 samples a pixel, no pixel left out, as a share of the brightest.
    double supersampled(const Scene &scene, const Technique &technique) {
        const Size fine{size.width * side, size.height * side};
        const Frame drawn = renderer_.render(scene, technique, fine, true);
        const ReferenceFrame truth = render_reference(scene, renderer_.resources().load(scene), technique, fine);
        double most = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                glm::dvec3 difference(0);
                for (int k = 0; k < side * side; ++k) {
                    const auto i = static_cast<std::size_t>((y * side + k / side) * fine.width + x * side + k % side);
                    difference += glm::dvec3(drawn.color.pixels[i]) - truth.color[i];
                }
                most = std::max(most, largest(difference) / (side * side));
            }
        }
        return most / brightest(truth);
    }

    Renderer &renderer() { return renderer_; }

  private:
    Renderer &renderer_;
};

// ---- list

struct Totals {
    std::size_t rows = 0, listed = 0, checked = 0, beyond = 0, unforetold = 0, untrusted = 0;
    double most = 0;
    std::string most_name;
};

void list_row(const std::string &name, const Scene &scene, const Technique &technique, double bound, Checker16 &check,
              Totals &totals) {
    Frame drawn;
    try {
        drawn = check.renderer().render(scene, technique, size, true);
    } catch (const InputError &) {
        return; // too many varyings
    }
    const ReferenceFrame truth = render_reference(scene, check.renderer().resources().load(scene), technique, size);
    const Metrics metrics = compare(drawn, truth, Flip::without);
    const auto shown = static_cast<double>(shown_pixels(metrics));
    if (shown < 50) {
        return; // nothing to see
    }
    ++totals.rows;
    std::string causes;
    for (const Mask &mask : masks) {
        const double share = static_cast<double>(metrics.*mask.pixels) / shown;
        if (share > listed_share) {
            causes += fmt::format("  {} {:.1f} % up to {:.2g}", mask.name, 100 * share, metrics.*mask.max_abs);
        }
    }
    const double masked = 1 - metrics.compared_share;
    if (masked > totals.most) {
        totals.most = masked;
        totals.most_name = name + " " + to_string(technique);
    }
    totals.untrusted += metrics.compared_share < trusted_share ? 1U : 0U;
    if (causes.empty()) {
        return;
    }
    ++totals.listed;
    std::string verdict;
    if (masked > checked_share) {
        ++totals.checked;
        const double error = check.supersampled(scene, technique);
        const bool beyond = !(error <= bound);
        const bool known = foretold(drawn, truth, scene, check.renderer().resources().load(scene), technique,
                                    bound * brightest(truth));
        totals.beyond += beyond ? 1U : 0U;
        totals.unforetold += known ? 0U : 1U;
        verdict = fmt::format("  16 samples: {:.2g} of {:.2g}{}{}", error, bound, beyond ? " BEYOND" : "",
                              known ? "" : " NOT FORETOLD");
    }
    fmt::print("{:<44} {:<44}{}{}\n", name, to_string(technique), causes, verdict);
}

int list(Checker16 &check) {
    Totals totals;
    const Assets assets("assets");
    for (const std::string &name : builtin_scenes(assets)) {
        const Scene scene = open_scene(name, assets);
        for (const Model model : all_models) {
            for (const Frequency frequency : all_frequencies) {
                const Technique technique{.frequency = frequency, .model = model};
                if (!why_refused(technique)) {
                    list_row(name, scene, technique, level, check, totals);
                }
            }
        }
    }
    for (const StabilityCase &one : stability_cases(assets)) {
        for (const Technique &technique : one.techniques) {
            list_row("stability " + one.name, one.scene, technique, std::max(one.bound, level), check, totals);
        }
    }
    for (const Scene &scene : feature_scenes()) {
        for (const char *technique : {"per-pixel/phong", "per-vertex/phong", "flat/blinn-phong", "hybrid/phong",
                                      "interpolated-vectors/blinn-phong"}) {
            list_row("feature " + scene.name, scene, parse_technique(technique), level, check, totals);
        }
    }
    for (unsigned seed = 0; seed < 60; ++seed) {
        for (unsigned i = 0; i < 4; ++i) {
            list_row(fmt::format("random {}", seed), random_scene(seed), random_technique(1000 * seed + i), level,
                     check, totals);
        }
    }
    for (std::uint32_t i = 0; i < 200; ++i) {
        const StressScene one = stress_scene(i % stress_families, i / stress_families);
        for (const Technique &technique : one.techniques) {
            list_row(fmt::format("stress {}", i), one.scene, technique, level, check, totals);
        }
    }
    fmt::print("{} rows: {} with a mask over {:.0f} %, {} with less than half compared; of {} with more than {:.0f} % "
               "left out, {} are beyond the bound with 16 samples, {} by more than jumps and lost directions; most is "
               "left out in {}: {:.1f} %\n",
               totals.rows, totals.listed, 100 * listed_share, totals.untrusted, totals.checked, 100 * checked_share,
               totals.beyond, totals.unforetold, totals.most_name, 100 * totals.most);
    return totals.unforetold == 0 ? 0 : 1;
}

// ---- search

/// The wrong picture: the same technique with one more fault, in double. Does the mask cover all that shows it?
std::string hidden_fault(const SpitefulScene &one, const std::vector<ObjectResources> &resources,
                         const ReferenceFrame &truth, const Technique &faulty) {
    const ReferenceFrame wrong = render_reference(one.scene, resources, faulty, size);
    const double bound = level * brightest(truth);
    const Metrics judged = compare(to_frame(wrong), truth, Flip::without);
    std::vector<bool> shows(truth.color.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < shows.size(); ++i) {
        const bool same = truth.object_ids[i] != 0 && wrong.object_ids[i] == truth.object_ids[i];
        shows[i] = same && largest(wrong.color[i] - truth.color[i]) > bound;
        differing += shows[i] ? 1U : 0U;
    }
    const bool hidden = !(judged.norms.max_abs > bound) && why_untrusted(judged).empty();
    if (!hidden || 20 * differing <= shown_pixels(judged)) {
        return {};
    }
    // Where roundings alone change the truth by as much, no figure could show the fault.
    const std::vector<bool> undecided = owed_pixels(one.scene, resources, one.technique, truth, bound, shows, 0);
    const auto decided = std::ranges::count_if(std::views::iota(std::size_t{0}, shows.size()),
                                               [&](std::size_t i) { return shows[i] && !undecided[i]; });
    return 20 * static_cast<std::size_t>(decided) > shown_pixels(judged)
               ? fmt::format("hides {} in {} pixels", to_string(faulty), decided)
               : "";
}

/// Pixels left out at jumps or for rounding whose truth nothing that float32 may do changes.
std::string unowed(const SpitefulScene &one, const std::vector<ObjectResources> &resources, const Frame &drawn,
                   const ReferenceFrame &truth, std::size_t shown) {
    const std::vector<PixelUse> uses = pixel_uses(drawn.object_ids, truth);
    const auto left_out = [&](std::size_t i) { return uses[i] == PixelUse::jump || uses[i] == PixelUse::rounding; };
    std::vector<bool> asked(uses.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        asked[i] = left_out(i);
        count += left_out(i) ? 1U : 0U;
    }
    const auto few = static_cast<std::size_t>(listed_share * static_cast<double>(shown));
    if (count <= few) {
        return {};
    }
    const std::vector<bool> owed = owed_pixels(one.scene, resources, one.technique, truth, change, asked, few);
    count = 0;
    double most = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (left_out(i) && !owed[i]) {
            ++count;
            most = std::max(most, largest(glm::dvec3(drawn.color.pixels[i]) - truth.color[i]));
        }
    }
    const double share = static_cast<double>(count) / static_cast<double>(shown);
    return share > listed_share ? fmt::format("covers {:.0f} % that are in no doubt, up to {:.2g}", 100 * share, most)
                                : "";
}

std::string finding(unsigned seed, const SpitefulScene &one, Checker16 &check) {
    const auto resources = check.renderer().resources().load(one.scene);
    const Frame drawn = check.renderer().render(one.scene, one.technique, size, true);
    const ReferenceFrame truth = render_reference(one.scene, resources, one.technique, size);
    const Metrics metrics = compare(drawn, truth, Flip::without);
    const std::size_t shown = shown_pixels(metrics);
    if (shown < 50) {
        return {};
    }
    if (metrics.nonfinite_pixels > 0) {
        return "not finite";
    }
    const double bound = level * brightest(truth);
    if (const std::string what = unowed(one, resources, drawn, truth, shown); !what.empty()) {
        return what;
    }
    if (metrics.norms.max_abs > bound &&
        Conditioning(one.scene, resources, one.technique, truth).unexplained(drawn) > level) {
        return fmt::format("is missing: {:.2g} at pixel {} {}", metrics.norms.max_abs,
                           metrics.worst_pixel % static_cast<std::size_t>(size.width),
                           metrics.worst_pixel / static_cast<std::size_t>(size.width));
    }
    if (1 - metrics.compared_share > checked_share && metrics.compared_share >= trusted_share) {
        const double error = check.supersampled(one.scene, one.technique);
        if (!(error <= level) && !foretold(drawn, truth, one.scene, resources, one.technique, bound)) {
            return fmt::format("hides {:.2g} with 16 samples, {:.0f} % left out", error,
                               100 * (1 - metrics.compared_share));
        }
    }
    const auto faulty = with_a_fault(one.scene, one.technique, seed);
    return faulty ? hidden_fault(one, resources, truth, *faulty) : "";
}

int search(Checker16 &check, unsigned first, unsigned count, double seconds) {
    const auto start = std::chrono::steady_clock::now();
    unsigned found = 0;
    unsigned seed = first;
    for (; seed < first + count; ++seed) {
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds) {
            break;
        }
        const SpitefulScene one = spiteful_scene(seed);
        try {
            if (const std::string what = finding(seed, one, check); !what.empty()) {
                ++found;
                fmt::print("seed {} {}: {}\n", seed, to_string(one.technique), what);
                std::fflush(stdout);
            }
        } catch (const InputError &) {
            // refused for this scene: too many varyings
        }
    }
    fmt::print("{} scenes from seed {}: {} findings\n", seed - first, first, found);
    return found == 0 ? 0 : 1;
}

int run(int count, char **words) {
    const std::string mode = count > 1 ? words[1] : "";
    const auto number = [&](int i, unsigned otherwise) {
        return count > i ? static_cast<unsigned>(std::stoul(words[i])) : otherwise;
    };
    const auto context = Context::headless();
    Renderer renderer(Assets("assets"), ShaderParts(Assets("shaders")));
    Checker16 check(renderer);
    if (mode == "list") {
        return list(check);
    }
    if (mode == "search") {
        return search(check, number(2, 0), number(3, 5000), number(4, 1200));
    }
    if (mode == "scene") {
        const SpitefulScene one = spiteful_scene(number(2, 0));
        fmt::print("{}\n{}\n", to_string(one.technique), scene_text(one.scene));
        return 0;
    }
    fmt::print(stderr, "usage: mask_check list | search [FIRST [COUNT [SECONDS]]] | scene SEED\n");
    return 2;
}

} // namespace
} // namespace sandbox

int main(int count, char **words) { return sandbox::run(count, words); }
