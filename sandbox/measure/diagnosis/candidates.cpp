#include "measure/diagnosis/candidates.h"

#include "shading/prepared_object.h"

#include <algorithm>
#include <map>

namespace sandbox {
namespace {

bool changes_equation(const TechniqueKey &key) { return key.is_fault() || key.name == "normalisation"; }

/// Puts techniques of one picture together.
class Collection {
  public:
    Collection(const Scene &scene, const std::vector<ObjectResources> &resources)
        : scene_(scene), resources_(resources) {}
    void add(const Technique &technique, std::size_t faults) {
        if (why_refused(technique) || !settings_without_effect(scene_, technique).empty()) {
            return;
        }
        const auto [place, is_new] = places_.try_emplace(object_features(scene_, technique, resources_), found_.size());
        if (is_new) {
            found_.push_back({technique, {}, faults});
        }
        found_[place->second].same.push_back(technique);
    }
    std::vector<Candidate> take() { return std::move(found_); }

  private:
    const Scene &scene_;
    const std::vector<ObjectResources> &resources_;
    std::map<std::vector<Features>, std::size_t> places_;
    std::vector<Candidate> found_;
};

/// Calls `visit` with `base` and each other value of each key from `from` on.
template <class Visit> void for_each_setting(const Technique &base, std::size_t from, Visit visit) {
    for (std::size_t i = from; i < std::size(technique_settings); ++i) {
        const TechniqueKey &key = technique_settings[i];
        for (int value = 1; changes_equation(key) && value < static_cast<int>(key.values.size()); ++value) {
            if (key.get(base) != value) {
                Technique technique = base;
                key.set(technique, value);
                visit(technique, i);
            }
        }
    }
}

} // namespace

std::vector<Technique> base_techniques(const std::optional<Technique> &given) {
    if (given && given->model != Model::own) {
        Technique base = *given;
        for (const TechniqueKey &key : technique_settings) {
            if (key.is_fault()) {
                key.set(base, 0);
            }
        }
        return {base};
    }
    std::vector<Technique> bases;
    const auto add = [&](const Technique &base) {
        if ((!given || given->frequency == base.frequency) && std::ranges::find(bases, base) == bases.end()) {
            bases.push_back(base);
        }
    };
    add({});
    for (const Frequency frequency : all_frequencies) {
        if (frequency == Frequency::automatic) {
            continue; // looks like per-pixel: that is its promise
        }
        for (const Model model : all_models) {
            Technique base;
            base.frequency = frequency;
            base.model = model;
            add(base);
        }
    }
    return bases;
}

std::vector<Candidate> single_candidates(const Scene &scene, const std::vector<ObjectResources> &resources,
                                         const std::vector<Technique> &bases) {
    Collection found(scene, resources);
    for (const Technique &base : bases) {
        found.add(base, 0);
    }
    for (const Technique &base : bases) {
        for_each_setting(base, 0, [&](const Technique &one, std::size_t) { found.add(one, 1); });
    }
    return found.take();
}

std::vector<Candidate> pair_candidates(const Scene &scene, const std::vector<ObjectResources> &resources,
                                       const std::vector<Technique> &bases) {
    Collection found(scene, resources);
    for (const Technique &base : bases) {
        for_each_setting(base, 0, [&](const Technique &one, std::size_t key) {
            for_each_setting(one, key + 1, [&](const Technique &two, std::size_t) { found.add(two, 2); });
        });
    }
    return found.take();
}

} // namespace sandbox
