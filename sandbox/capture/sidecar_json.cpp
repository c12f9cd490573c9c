#include "capture/sidecar_json.h"

#include "scene/read_json.h"

#include <nlohmann/json.hpp>

namespace sandbox {

nlohmann::ordered_json sidecar_json(std::string_view text, std::string_view name) {
    auto json = begins_object(text) ? read_json<nlohmann::ordered_json>(text, name) : nlohmann::ordered_json::object();
    return json.contains("scene") ? json : nlohmann::ordered_json::object();
}

} // namespace sandbox
