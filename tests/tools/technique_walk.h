#pragma once

#include "shading/technique.h"

#include <functional>
#include <vector>

namespace sandbox {

/// Calls `visit` with every combination of every key's values, valid or not.
void for_each_technique(const std::function<void(const Technique &)> &visit);

/// Valid techniques in which every valid pair of values of two keys occurs at least once. Deterministic.
std::vector<Technique> pairwise_techniques();

} // namespace sandbox
