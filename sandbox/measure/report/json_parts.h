#pragma once

#include "measure/report/report.h"

#include <nlohmann/json_fwd.hpp>

/// What reading and writing report.json share: inside this room's report_json*.cpp only.
namespace sandbox::report_parts {

constexpr std::string_view format = "shading-sandbox report 1";

nlohmann::ordered_json machine_json(const Machine &machine);
Machine machine_from(const nlohmann::ordered_json &json);

nlohmann::ordered_json row_json(const MeasuredRow &row, const std::vector<PlannedMesh> &meshes);
/// Throws nlohmann's exceptions or InputError.
MeasuredRow row_from(const nlohmann::ordered_json &json);

} // namespace sandbox::report_parts
