#pragma once

#include "measure/work_precision/run.h"

#include <string>
#include <string_view>

/// How the report writes numbers and names.
namespace sandbox {

/// Three digits: "0.00123", "4.56e-07", "12.3"; "none" for 0, "not finite".
std::string short_number(double value);
/// As a table shows milliseconds: "0.123", "12.3".
std::string milliseconds_text(double value);
/// "16 rings", "the scene's own mesh".
std::string mesh_words(const PlannedMesh &mesh);
/// Of an error bound: "1/255", "1e-5".
std::string bound_name(double bound);
/// & < > " become entities.
std::string escaped(std::string_view text);
std::string base64(std::string_view bytes);

} // namespace sandbox
