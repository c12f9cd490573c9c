#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

std::vector<std::string> split_lines(std::string_view text);

/// For each line of `left`: is it missing from `right`? By the longest common subsequence; indentation does not count.
std::vector<bool> lines_missing(const std::vector<std::string> &left, const std::vector<std::string> &right);

/// True if `line` stands somewhere in `lines`, apart from indentation; never for blank lines and lone braces, which
/// stand everywhere.
bool holds_line(const std::vector<std::string> &lines, std::string_view line);

} // namespace sandbox
