#pragma once

#include "scene/scene.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

/// JSON as text: inside this room's scene_*.cpp files only.
namespace sandbox {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json; ///< keeps the format's order of keys

/// JSON to text: two-space indent, whatever fits on a line on one line, whole numbers without ".0".
std::string print_json(const OrderedJson &json);

} // namespace sandbox
