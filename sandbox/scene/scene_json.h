#pragma once

#include "scene/scene.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

/// JSON as text: inside this room's scene_*.cpp files only.
namespace sandbox {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json; ///< keeps the format's order of keys

/// Text to JSON. Throws InputError: `name:line:column: ...`; refuses keys given twice, deep nesting, 16 MiB and more.
Json parse_json(std::string_view text, std::string_view name);

/// JSON to text: two-space indent, whatever fits on a line on one line, whole numbers without ".0".
std::string print_json(const OrderedJson &json);

} // namespace sandbox
