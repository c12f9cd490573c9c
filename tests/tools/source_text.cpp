#include "tools/source_text.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace sandbox {
namespace {

/// Where the comment, string or character that begins at `at` ends (one past it), or `at` if none does.
std::size_t end_of_quoted(const std::string &text, std::size_t at) {
    const auto past = [&](const std::string &close, std::size_t from) {
        const auto found = text.find(close, from);
        return found == std::string::npos ? text.size() : found + close.size();
    };
    if (text.compare(at, 2, "//") == 0) {
        return std::min(text.find('\n', at), text.size());
    }
    if (text.compare(at, 2, "/*") == 0) {
        return past("*/", at + 2);
    }
    if (text.compare(at, 2, "R\"") == 0) {
        const auto open = text.find('(', at);
        return open == std::string::npos ? text.size() : past(")" + text.substr(at + 2, open - at - 2) + "\"", open);
    }
    const bool digit_separator =
        at > 0 && text[at] == '\'' && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
    if ((text[at] != '"' && text[at] != '\'') || digit_separator) {
        return at;
    }
    auto end = at + 1;
    while (end < text.size() && text[end] != text[at]) {
        end += text[end] == '\\' ? 2 : 1;
    }
    return std::min(end + 1, text.size());
}

} // namespace

std::map<std::string, std::string> source_files(const std::string &folder, const std::vector<std::string> &extensions) {
    std::map<std::string, std::string> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder)) {
        const auto extension = entry.path().extension().string();
        if (entry.is_regular_file() && std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
            std::ifstream file(entry.path(), std::ios::binary);
            std::ostringstream text;
            text << file.rdbuf();
            files[std::filesystem::relative(entry.path(), folder).generic_string()] = text.str();
        }
    }
    return files;
}

std::vector<std::string> includes_of(const std::string &text) {
    static const std::regex include("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
    std::vector<std::string> names;
    std::istringstream lines(text);
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, found, include)) {
            names.push_back(found[1]);
        }
    }
    return names;
}

std::string without_comments_and_strings(const std::string &text) {
    std::string code;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = end_of_quoted(text, at);
        if (end == at) {
            code += text[at++];
            continue;
        }
        const auto lines = std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                      text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        code.append(static_cast<std::size_t>(lines), '\n');
        at = end;
    }
    return code;
}

} // namespace sandbox
