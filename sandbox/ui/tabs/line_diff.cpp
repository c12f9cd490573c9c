#include "ui/tabs/line_diff.h"

#include <algorithm>

namespace sandbox {

namespace {

std::string_view trimmed(std::string_view line) {
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

bool same(const std::string &a, const std::string &b) { return trimmed(a) == trimmed(b); }

} // namespace

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const auto end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

std::vector<bool> lines_missing(const std::vector<std::string> &left, const std::vector<std::string> &right) {
    const std::size_t rows = left.size();
    const std::size_t columns = right.size();
    // common[i][j]: length of the longest common subsequence of left from i and right from j
    std::vector<std::vector<int>> common(rows + 1, std::vector<int>(columns + 1, 0));
    for (std::size_t i = rows; i-- > 0;) {
        for (std::size_t j = columns; j-- > 0;) {
            common[i][j] =
                same(left[i], right[j]) ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
        }
    }
    std::vector<bool> missing(rows, true);
    for (std::size_t i = 0, j = 0; i < rows && j < columns;) {
        if (same(left[i], right[j])) {
            missing[i++] = false;
            ++j;
        } else if (common[i + 1][j] >= common[i][j + 1]) {
            ++i;
        } else {
            ++j;
        }
    }
    return missing;
}

bool holds_line(const std::vector<std::string> &lines, std::string_view line) {
    const std::string_view wanted = trimmed(line);
    return wanted.size() > 2 && std::ranges::any_of(lines, [wanted](const auto &l) { return trimmed(l) == wanted; });
}

} // namespace sandbox
