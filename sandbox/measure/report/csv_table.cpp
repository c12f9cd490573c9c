#include "measure/report/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sandbox {
namespace {

std::string quoted(const std::string &text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string out = "\"";
    for (const char c : text) {
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    return out + "\"";
}

} // namespace

void CsvTable::cell(const std::string &column, std::string_view text) {
    const auto [number, added] = column_numbers_.try_emplace(column, columns_.size());
    if (added) {
        columns_.push_back(column);
    }
    rows_.back().resize(std::max(rows_.back().size(), number->second + 1));
    rows_.back()[number->second] = text;
}

void CsvTable::cell(const std::string &column, double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value);
    cell(column, std::isfinite(value) ? std::string_view(text, end.ptr) : "inf");
}

std::string CsvTable::text() const {
    std::string out;
    const auto add_line = [&](const std::vector<std::string> &cells) {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            out += (i > 0 ? "," : "") + (i < cells.size() ? quoted(cells[i]) : std::string());
        }
        out += "\r\n";
    };
    add_line(columns_);
    for (const auto &row : rows_) {
        add_line(row);
    }
    return out;
}

} // namespace sandbox
