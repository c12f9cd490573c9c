#include "certificate/light_groups.h"

#include <bit>
#include <utility>

namespace sandbox::certificate {
namespace {

struct Group {
    AreaOfLights seen;
    LightSet lights = 0;
    double area = 0;

    void add(const std::pair<const LightSet, double> &triangles) {
        seen.insert(triangles);
        lights |= triangles.first;
        area += triangles.second;
    }
    [[nodiscard]] double cost() const { return area * std::popcount(lights); }
};

/// Without the light, and with it.
std::pair<Group, Group> divided(const Group &group, LightSet light) {
    std::pair<Group, Group> halves;
    for (const auto &triangles : group.seen) {
        ((triangles.first & light) == 0 ? halves.first : halves.second).add(triangles);
    }
    return halves;
}

/// The best division of a group, and what it saves.
struct Division {
    std::size_t group = 0;
    LightSet light = 0;
    double saved = 0;
};
Division best_division(const Group &group) {
    Division best;
    for (LightSet left = group.lights; left != 0; left &= left - 1) {
        const LightSet light = left & (~left + 1); // its lowest bit
        const auto [without, with] = divided(group, light);
        if (const double saved = group.cost() - without.cost() - with.cost(); saved > best.saved) {
            best = {0, light, saved};
        }
    }
    return best;
}

} // namespace

LightGroups group_by_lights(const AreaOfLights &areas, double least_saved, std::size_t most) {
    std::vector<Group> groups(1);
    for (const auto &triangles : areas) {
        groups[0].add(triangles);
    }
    while (groups.size() < most) {
        Division best;
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (const Division own = best_division(groups[i]); own.saved > best.saved) {
                best = {i, own.light, own.saved};
            }
        }
        if (best.saved <= least_saved) {
            break;
        }
        auto [without, with] = divided(groups[best.group], best.light);
        groups[best.group] = std::move(without);
        groups.push_back(std::move(with));
    }
    LightGroups result;
    for (const Group &group : groups) {
        for (const auto &[seen, area] : group.seen) {
            result.group_of[seen] = result.lights.size();
        }
        result.lights.push_back(group.lights);
    }
    return result;
}

} // namespace sandbox::certificate
