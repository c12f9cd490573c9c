#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What answers are called, by people nobody knows: for eyes, for spreadsheets, and as file names.
namespace sandbox {

/// A cell that no spreadsheet takes for a formula: what begins with = + - @ or a tab gets ' in front.
std::string plain_cell(std::string_view text);

/// The name of each answer's page, without a folder: NAME.html, made safe for every file system. No two are alike, not
/// even but for upper case; the same names give the same pages.
std::vector<std::string> page_names(const std::vector<std::string> &answers);

} // namespace sandbox
