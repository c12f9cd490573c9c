#pragma once

#include <string>
#include <vector>

namespace sandbox {

/// What is wrong with the texts of the frame that Dear ImGui has just laid out: those that the side of their window or
/// column cuts off, and those that lie over others of the same window. What scrolls out is
/// right.
std::vector<std::string> text_faults();

} // namespace sandbox
