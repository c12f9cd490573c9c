#pragma once

#include "shading/technique.h"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace sandbox {

/// "per-vertex/phong", the technique's text; with own shading {"technique": text, "file": its name, "own": its GLSL}.
/// For a file in `folder` (empty: for none) the name is relative to that where it can be, see path_from().
nlohmann::ordered_json technique_json(const Technique &technique, const std::filesystem::path &folder = {});
/// Throws InputError for a technique that is refused, nlohmann::json::exception for what is none.
Technique technique_of(const nlohmann::ordered_json &json, const std::filesystem::path &folder = {});

} // namespace sandbox
