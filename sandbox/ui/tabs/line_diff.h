#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

std::vector<std::string> split_lines(std::string_view text);

/// Which lines of `left` are missing from `right`, by the longest common subsequence; ignores indentation.
std::vector<bool> lines_missing(const std::vector<std::string> &left, const std::vector<std::string> &right);

/// True if `lines` has `line`, apart from indentation; false for blank lines and lone braces, which are everywhere.
bool holds_line(const std::vector<std::string> &lines, std::string_view line);

} // namespace sandbox
