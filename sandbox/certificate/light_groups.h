#pragma once

#include "shading/object_lights.h"

#include <cstddef>
#include <map>
#include <vector>

/// Triangles that are drawn together because much the same lights reach them.
namespace sandbox::certificate {

/// The area of all triangles that see exactly these lights.
using AreaOfLights = std::map<LightSet, double>;

struct LightGroups {
    std::vector<LightSet> lights; ///< of each group: all that some triangle of it sees
    std::map<LightSet, std::size_t> group_of;
};

/// At most `most` groups, at least one. Each time the group is divided, by whether a light is seen, that saves the most
/// area times lights: as long as it is more than `least_saved`, for a draw costs, too.
LightGroups group_by_lights(const AreaOfLights &areas, double least_saved, std::size_t most);

} // namespace sandbox::certificate
