#include "measure/diagnosis/proposal.h"

#include "image/error.h"
#include "measure/diagnosis/levels.h"
#include "scene/light_kind.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"

#include <algorithm>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

namespace sandbox {
namespace {

constexpr Size trial_size{120, 90};
/// Levels: a scene that tells all by so many is good enough, whatever others might do.
constexpr double plenty = 24;
/// ... and trials after it that tell no more.
constexpr std::size_t most_in_vain = 8;
/// A few pixels at an edge tell nothing.
constexpr std::size_t least_pixels = 6;

/// Changes of the scene at hand that faults show under.
std::vector<std::string> changes_of(const Scene &scene) {
    const auto vector = [](const glm::dvec3 &v) { return fmt::format("[{:.4g},{:.4g},{:.4g}]", v.x, v.y, v.z); };
    std::vector<std::string> changes;
    const glm::dvec3 away = scene.camera.position - scene.camera.target;
    const auto seen_from = [&](const glm::dvec3 &offset) {
        changes.push_back("camera.position=" + vector(scene.camera.target + offset));
    };
    seen_from({away.z, away.y, -away.x});  // from the side
    seen_from({-away.x, away.y, -away.z}); // from behind
    seen_from(0.6 * away);
    for (std::size_t i = 0; i < scene.lights.size() && i < 2; ++i) {
        const Light &light = scene.lights[i];
        const auto change = [&](const char *key, const std::string &value) {
            changes.push_back(fmt::format("lights[{}].{}={}", i, key, value));
        };
        const glm::dvec3 above{0, 0.2 * glm::length(away), 0};
        if (!has_position(light)) {
            change("direction", vector(away - above)); // from behind: only grazing light is seen
            continue;
        }
        change("position", vector(scene.camera.target - 0.7 * away + above));
        change("position", vector(scene.camera.target + 0.3 * (light.position - scene.camera.target)));
        change("attenuation.quadratic", fmt::format("{:g}", light.attenuation.quadratic + 1));
    }
    for (std::size_t i = 0; i < scene.objects.size() && i < 2; ++i) {
        const Object &object = scene.objects[i];
        const auto change = [&](const char *key, const std::string &value) {
            changes.push_back(fmt::format("objects[{}].{}={}", i, key, value));
        };
        change("material.shininess", fmt::format("{:g}", std::clamp(object.material.shininess / 4, 1.0, 1e6)));
        change("material.shininess", fmt::format("{:g}", std::clamp(object.material.shininess * 4, 1.0, 1e6)));
        change("transform.scale", vector(object.transform.scale * glm::dvec3(1.6, 0.7, 1)));
        change("transform.rotate_degrees", vector(object.transform.rotate_degrees + glm::dvec3(20, 40, 0)));
        change("transform.translate", vector(object.transform.translate + glm::dvec3(0.8, 0.3, 0)));
    }
    return changes;
}

struct Told {
    std::vector<Technique> ties; ///< that differ from the technique
    double least = std::numeric_limits<double>::infinity();
    std::size_t pairs = 0; ///< of the technique and its ties that differ from each other
    [[nodiscard]] bool better_than(const Told &other) const {
        return pairs != other.pairs ? pairs > other.pairs : least > other.least;
    }
};

Told told_by(const Scene &scene, const Technique &technique, const std::vector<Technique> &ties, Sampler &sampler,
             const std::function<void()> &report) {
    Told told;
    report();
    std::vector<Levels> drawn{shown_levels(sampler.drawn(scene, technique), {}, true)};
    const std::vector<std::uint8_t> everywhere(drawn[0].size() / 3, 1); // the background is the same
    for (const Technique &tie : ties) {
        report();
        Levels levels = shown_levels(sampler.drawn(scene, tie), {}, true);
        for (const Levels &earlier : drawn) {
            const Difference difference = difference_of(earlier, levels, everywhere, told_levels);
            if (difference.over < least_pixels) {
                continue;
            }
            ++told.pairs;
            if (&earlier == &drawn.front()) {
                told.ties.push_back(tie);
                told.least = std::min(told.least, difference.largest);
            }
        }
        drawn.push_back(std::move(levels));
    }
    return told;
}

} // namespace

std::vector<TrialScene> changed_scenes(const Scene &scene, const std::string &arguments) {
    std::vector<TrialScene> trials;
    const auto add = [&](const std::string &words, const Scene &trial) {
        if (!(trial == scene)) {
            trials.push_back({words, trial});
        }
    };
    for (const View &view : scene.views) {
        add(arguments + " --view " + view.name, with_view(scene, view.name));
    }
    for (const std::string &change : changes_of(scene)) {
        try {
            add(fmt::format("{} --set {}", arguments, change), with_setting(scene, change));
        } catch (const InputError &) {
            continue; // the scene takes no such change: an object without that key
        }
    }
    return trials;
}

std::vector<TrialScene> builtin_trials(const Assets &assets) {
    std::vector<TrialScene> trials;
    for (const std::string &name : builtin_scenes(assets)) {
        const Scene scene = open_scene(name, assets);
        trials.push_back({name, scene});
        for (const View &view : scene.views) {
            trials.push_back({name + " --view " + view.name, with_view(scene, view.name)});
        }
    }
    return trials;
}

std::vector<TrialScene> trial_scenes(const Scene &scene, const std::string &arguments, const Assets &assets) {
    std::vector<TrialScene> trials = changed_scenes(scene, arguments);
    std::ranges::copy(builtin_trials(assets), std::back_inserter(trials));
    return trials;
}

std::optional<Proposal> propose(const Technique &technique, const std::vector<Technique> &ties,
                                const std::vector<TrialScene> &trials, const DiagnosisDraw &draw,
                                const std::function<void()> &report) {
    std::vector<Technique> tried = ties;
    tried.resize(std::min(tried.size(), most_tried_ties));
    const std::size_t all_pairs = tried.size() * (tried.size() + 1) / 2;
    Sampler sampler(draw, {trial_size, trial_size, 1});
    Told best;
    const TrialScene *chosen = nullptr;
    std::size_t since = 0;
    for (const TrialScene &trial : trials) {
        if (chosen != nullptr && best.least >= plenty && ++since > most_in_vain) {
            break;
        }
        Told told = told_by(trial.scene, technique, tried, sampler, report);
        if (!told.ties.empty() && (chosen == nullptr || told.better_than(best))) {
            best = std::move(told);
            chosen = &trial;
            since = 0;
            if (best.pairs == all_pairs && best.least >= plenty) {
                break;
            }
        }
    }
    if (chosen == nullptr) {
        return std::nullopt;
    }
    return Proposal{chosen->arguments, chosen->scene, std::move(best.ties), best.least};
}

} // namespace sandbox
