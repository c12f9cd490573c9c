#pragma once

#include "shading/technique.h"

#include <string_view>

namespace sandbox {

/// What people call a fault: "attenuation per vertex" for attenuation=interpolated. Empty for a key's default and for
/// keys that are no faults.
std::string_view fault_name(const TechniqueKey &key, int value);

} // namespace sandbox
