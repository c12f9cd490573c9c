#pragma once

#include "measure/diagnosis/pictures.h"
#include "scene/assets.h"

#include <functional>
#include <string>
#include <vector>

namespace sandbox {

/// A scene in which techniques that look alike elsewhere may differ.
struct TrialScene {
    std::string arguments; ///< as commands take it: "vase", "studio --set camera.position=[0,1,6]"
    Scene scene;
};
/// `scene`, which commands call `arguments`, turned, seen nearer, under moved lights and with other materials.
std::vector<TrialScene> changed_scenes(const Scene &scene, const std::string &arguments);
/// The built-in scenes under all their views.
std::vector<TrialScene> builtin_trials(const Assets &assets);
/// Both.
std::vector<TrialScene> trial_scenes(const Scene &scene, const std::string &arguments, const Assets &assets);

/// The trial that tells most of a technique and its ties apart from each other, among those by most levels of 8 bits.
struct Proposal {
    std::string arguments;
    Scene scene;
    std::vector<Technique> told; ///< the ties that differ there by at least told_levels
    double levels = 0;           ///< the least of those differences' largest
};
constexpr double told_levels = 3;

/// Draws small pictures of the trials, until one is good and many after it are no better; nothing where no trial tells
/// any tie. At most most_tried_ties are drawn.
std::optional<Proposal> propose(const Technique &technique, const std::vector<Technique> &ties,
                                const std::vector<TrialScene> &trials, const DiagnosisDraw &draw,
                                const std::function<void()> &report);
constexpr std::size_t most_tried_ties = 12;

} // namespace sandbox
