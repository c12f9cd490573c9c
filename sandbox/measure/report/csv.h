#pragma once

#include "measure/report/report.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// A table as CSV (RFC 4180). Columns stand in the order of their first cell; a row may leave any of them empty.
class CsvTable {
  public:
    void begin_row() { rows_.emplace_back(); }
    void cell(const std::string &column, std::string_view text);
    /// The shortest text that reads back as the same number; "inf" if it is infinite, empty if it is NaN.
    void cell(const std::string &column, double value);
    /// "inf" for a quantity that is absent, too: the psnr of identical pictures. Empty where nothing could be measured.
    template <class T> void cell(const std::string &column, const Quantity<T> &quantity, const T &measured) {
        cell(column, quantity.value(measured).value_or(std::numeric_limits<double>::infinity()));
    }
    /// The columns' names, then a line a row.
    [[nodiscard]] std::string text() const;

  private:
    std::vector<std::string> columns_;
    std::map<std::string, std::size_t> column_numbers_;
    std::vector<std::vector<std::string>> rows_;
};

/// report.csv: a header, then one line per row of the report; the columns hold all that the report says of the row.
std::string report_csv(const std::vector<ReportRun> &runs);

} // namespace sandbox
