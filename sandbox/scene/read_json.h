#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// The one way from a file's text to JSON, for all that people may hand in: scenes, sidecars, reports, lessons,
/// exercises, cases, words and settings. Linear in time, and bounded before anything is built.
namespace sandbox {

constexpr std::size_t largest_json = std::size_t{16} << 20; ///< bytes
constexpr std::size_t most_json_values = 1000000;           ///< in one text, arrays and objects among them
constexpr std::size_t deepest_json = 64;                    ///< arrays and objects around a value

/// `Json`: nlohmann::json or nlohmann::ordered_json, which headers do not name. Throws InputError: `name:line:column:
/// ...` for what is no JSON, `name: path: ...` for a key given twice or a number beyond a double, `name: expected ...`
/// for what is larger than the bounds above.
template <class Json> Json read_json(std::string_view text, std::string_view name);

/// A value in a message: at most 60 characters of it, or how many elements it has.
template <class Json> std::string short_json(const Json &json);

/// Whether the first thing in a text is {, as in every JSON object and in no OBJ file.
bool begins_object(std::string_view text);

} // namespace sandbox
