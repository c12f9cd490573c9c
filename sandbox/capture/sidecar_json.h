#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace sandbox {

/// What a sidecar says; an empty object if `text` is none (a scene file, an OBJ). Throws InputError, see read_json().
nlohmann::ordered_json sidecar_json(std::string_view text, std::string_view name);

} // namespace sandbox
