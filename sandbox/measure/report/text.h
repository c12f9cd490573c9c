#pragma once

#include "measure/work_precision/findings.h"
#include "words/row_words.h"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <string>

/// How pages, tables and the window write numbers and names.
namespace sandbox {

/// Three digits: "0.00123", "4.56e-07", "12.3"; "not finite"; "none" of NaN, where nothing was compared.
std::string short_number(double value);
/// The same in the language of `words`.
std::string short_number(const Words &words, double value);
/// A count, or three digits; "none" where there is no such number.
template <class T> std::string quantity_text(const Words &words, const Quantity<T> &quantity, const T &measured) {
    const double value = quantity.value(measured).value_or(std::nan(""));
    return quantity.whole() && !std::isnan(value) ? fmt::format("{:.0f}", value) : short_number(words, value);
}
/// As a table shows milliseconds: "0.123", "12.3".
std::string milliseconds_text(double value);
/// "16 rings", "the scene's own mesh"
std::string mesh_words(const Words &words, const PlannedMesh &mesh);
/// "16 rings", "own mesh"
std::string short_mesh_words(const Words &words, const PlannedMesh &mesh);
/// "RMSE", "99th percentile", "largest"
std::string title_of(const Words &words, ErrorNorm norm);
/// "root mean square error"
std::string long_title_of(const Words &words, ErrorNorm norm);
/// "silhouette"
std::string title_of(const Words &words, const Mask &mask);
/// "8-bit levels"
std::string unit_title(const Words &words, std::string_view unit);
/// What a quantity is: "largest error"; the head of its column on a page, without soft hyphens: "largest".
template <class T> std::string meaning_of(const Words &words, const Quantity<T> &row) {
    return row_text(words, fmt::format("metric.{}", row.name), row.meaning);
}
template <class T> std::string heading_of(const Words &words, const Quantity<T> &row) {
    return row_text(words, fmt::format("metric.{}.heading", row.name), row.heading);
}
std::string heading_of(const Words &words, const ErrorPart &part);
/// "float32 arithmetic"
std::string title_of(const Words &words, const ErrorPart &part);
/// As why_untrusted().
std::string why_untrusted(const Words &words, const Metrics &metrics);
/// The texts of these tables' rows by key, in English, as row_texts() has those of other tables.
std::map<std::string, std::string> measured_row_texts();
/// Of an error bound: "1/255", "1e-5".
std::string bound_name(double bound);

} // namespace sandbox
