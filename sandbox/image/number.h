#pragma once

#include <charconv>

namespace sandbox {

/// std::from_chars() for a double, which the page's C++ library has not got.
std::from_chars_result read_number(const char *first, const char *last, double &value);

} // namespace sandbox
