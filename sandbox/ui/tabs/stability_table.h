#pragma once

#include "ui/jobs/stability_list.h"
#include "ui/session/session.h"

#include <imgui.h>
#include <optional>
#include <vector>

namespace sandbox {

/// The cases that `filter` lets through, by group, in the current ImGui window; symptoms and costs where there is room.
/// Returns the number of the case that was clicked.
std::optional<std::size_t> case_table(Session &session, const std::vector<ListedCase> &cases, const CaseFilter &filter,
                                      std::optional<std::size_t> chosen, ImVec2 size);

} // namespace sandbox
