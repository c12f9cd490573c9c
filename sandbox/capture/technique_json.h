#pragma once

#include "shading/technique.h"

#include <nlohmann/json_fwd.hpp>

namespace sandbox {

/// "per-vertex/phong", the technique's text; with own shading {"technique": text, "file": its name, "own": its GLSL}.
nlohmann::ordered_json technique_json(const Technique &technique);
/// Throws InputError for a technique that is refused, nlohmann::json::exception for what is none.
Technique technique_of(const nlohmann::ordered_json &json);

} // namespace sandbox
