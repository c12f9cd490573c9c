#pragma once

#include "teach/marking/marks_report.h"

#include <span>
#include <string>

namespace sandbox {

/// The page of one answer, self-contained.
std::string mark_html(const Words &words, const Exercise &exercise, const MarkedAnswer &answer);

/// Links to the pages of all.
std::string marks_index(const Words &words, const Exercise &exercise, std::span<const MarkedAnswer> answers);

} // namespace sandbox
