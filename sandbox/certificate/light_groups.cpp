#include "certificate/light_groups.h"

#include "image/thread.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace sandbox::certificate {
namespace {

/// Of some triangles.
struct Reach {
    LightSet lights = 0; ///< that any of them sees
    double area = 0;

    void add(LightSet seen, double of_area) {
        lights |= seen;
        area += of_area;
    }
    [[nodiscard]] double cost() const { return area * std::popcount(lights); }
};

using Triangles = std::vector<std::pair<LightSet, double>>; ///< the lights they see, their area
struct Group {
    Triangles triangles;
    Reach reach;
    LightSet divider = 0; ///< the light that divides it best
    double saved = 0;     ///< by that

    explicit Group(Triangles of) : triangles(std::move(of)) {
        for (const auto &[seen, area] : triangles) {
            reach.add(seen, area);
        }
        for (LightSet left = reach.lights; left != 0; left &= left - 1) {
            let_others_run();
            const LightSet light = left & (~left + 1); // its lowest bit
            std::array<Reach, 2> halves;
            for (const auto &[seen, area] : triangles) {
                halves[(seen & light) != 0 ? 1 : 0].add(seen, area);
            }
            if (const double by_light = reach.cost() - halves[0].cost() - halves[1].cost(); by_light > saved) {
                divider = light;
                saved = by_light;
            }
        }
    }
};

} // namespace

LightGroups group_by_lights(const AreaOfLights &areas, double least_saved, std::size_t most) {
    std::vector<Group> groups{Group(Triangles(areas.begin(), areas.end()))};
    while (groups.size() < most) {
        const auto best = std::ranges::max_element(groups, {}, &Group::saved);
        if (best->saved <= least_saved) {
            break;
        }
        Triangles all = std::move(best->triangles);
        const auto with =
            std::ranges::partition(all, [&](const auto &seen) { return (seen.first & best->divider) == 0; });
        Triangles seeing(with.begin(), with.end());
        all.erase(with.begin(), with.end());
        *best = Group(std::move(all));
        groups.emplace_back(std::move(seeing));
    }
    LightGroups result;
    for (const Group &group : groups) {
        for (const auto &[seen, area] : group.triangles) {
            result.group_of[seen] = result.lights.size();
        }
        result.lights.push_back(group.reach.lights);
    }
    return result;
}

} // namespace sandbox::certificate
