#pragma once

#include <optional>
#include <vector>

namespace sandbox {

/// The factors c that bring sum c[j] columns[j] nearest to `target`, by least squares. Where columns cannot be told
/// apart, the factors nearest to 1. All have the same length; nothing if there are no rows or no columns.
std::optional<std::vector<double>> fitted_factors(const std::vector<std::vector<double>> &columns,
                                                  const std::vector<double> &target);

} // namespace sandbox
