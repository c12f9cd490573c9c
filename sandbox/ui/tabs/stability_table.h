#pragma once

#include "ui/jobs/stability_list.h"
#include "ui/session/session.h"

#include <imgui.h>
#include <optional>
#include <vector>

namespace sandbox {

/// Blue where a bound holds, the error colour where it breaks: apart for all eyes, and the word stands there too.
ImVec4 verdict_color(Verdict verdict);

/// The cases that `filter` lets through, by group, in the current ImGui window; symptoms and costs where there is room.
/// Returns the number of the case that was clicked.
std::optional<std::size_t> case_table(Session &session, const std::vector<ListedCase> &cases, const CaseFilter &filter,
                                      std::optional<std::size_t> chosen, ImVec2 size);

} // namespace sandbox
