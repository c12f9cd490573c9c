#pragma once

#include "measure/stability.h"

#include <filesystem>

namespace sandbox {

/// Writes stability.html, stability.json and stability.csv, as the command `stability` does, into a new folder
/// stability-001, or the first number that is free, where captures go. Returns it, absolute. Throws InputError.
std::filesystem::path write_stability(const StabilityRun &run);

} // namespace sandbox
