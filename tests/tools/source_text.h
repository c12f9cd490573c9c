#pragma once

#include <map>
#include <string>
#include <vector>

/// Source files as text, for the tests that read the code itself.
namespace sandbox {

/// Every file below `folder` with one of the extensions: its path below `folder` to its text.
std::map<std::string, std::string> source_files(const std::string &folder, const std::vector<std::string> &extensions);

/// The names that C++ text includes, without quotes or brackets.
std::vector<std::string> includes_of(const std::string &text);

/// C++ text with comments, strings and characters emptied; lines stay lines.
std::string without_comments_and_strings(const std::string &text);

} // namespace sandbox
