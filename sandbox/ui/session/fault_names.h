#pragma once

#include "shading/technique.h"
#include "words/words.h"

#include <string>

namespace sandbox {

/// What people call a fault: "attenuation per vertex" for attenuation=interpolated. Empty for a key's default and for
/// keys that are no faults.
std::string fault_name(const Words &words, const TechniqueKey &key, int value);

} // namespace sandbox
