#include "tools/technique_walk.h"

#include <random>
#include <set>
#include <tuple>

namespace sandbox {
namespace {

using Pair = std::tuple<std::size_t, int, std::size_t, int>; ///< key, value, key, value

std::set<Pair> pairs_of(const Technique &technique) {
    const auto keys = technique_keys();
    std::set<Pair> pairs;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        for (std::size_t j = i + 1; j < keys.size(); ++j) {
            pairs.emplace(i, keys[i].get(technique), j, keys[j].get(technique));
        }
    }
    return pairs;
}

/// Of the frequency auto, or of another.
Technique random_technique(std::mt19937 &random, bool automatic) {
    Technique technique;
    for (const auto &key : technique_keys()) {
        const std::size_t values = key.name == model_key.name       ? all_models.size() // own shading needs a text
                                   : key.name == frequency_key.name ? all_frequencies.size() - 1
                                                                    : key.values.size();
        key.set(technique, static_cast<int>(random() % values));
    }
    technique.frequency = automatic ? Frequency::automatic : technique.frequency;
    return technique;
}

} // namespace

void for_each_technique(const std::function<void(const Technique &)> &visit) {
    const auto keys = technique_keys();
    Technique technique;
    for (const auto &key : keys) {
        key.set(technique, 0);
    }
    while (true) {
        visit(technique);
        std::size_t i = 0;
        for (; i < keys.size(); ++i) { // count up, the first key fastest
            const int next = keys[i].get(technique) + 1;
            const bool carries = next == static_cast<int>(keys[i].values.size());
            keys[i].set(technique, carries ? 0 : next);
            if (!carries) {
                break;
            }
        }
        if (i == keys.size()) {
            return;
        }
    }
}

std::vector<Technique> pairwise_techniques() {
    constexpr int tries_without_news = 20000;
    std::mt19937 random(20);
    std::set<Pair> covered;
    std::vector<Technique> chosen;
    for (const bool automatic : {false, true}) { // one after the other: a new value leaves the earlier choice as it was
        for (int idle = 0; idle < tries_without_news; ++idle) {
            const Technique technique = random_technique(random, automatic);
            if (why_refused(technique)) {
                continue;
            }
            std::size_t news = 0;
            for (const Pair &pair : pairs_of(technique)) {
                news += covered.insert(pair).second ? 1U : 0U;
            }
            if (news > 0) {
                chosen.push_back(technique);
                idle = 0;
            }
        }
    }
    return chosen;
}

} // namespace sandbox
