#include "image/number.h"

#ifdef __EMSCRIPTEN__
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>
#endif

namespace sandbox {

#ifndef __EMSCRIPTEN__

std::from_chars_result read_number(const char *first, const char *last, double &value) {
    return std::from_chars(first, last, value);
}

#else

/// strtod() reads more than from_chars(): white space and a plus before a number, and hexadecimal digits after 0x.
std::from_chars_result read_number(const char *first, const char *last, double &value) {
    const std::string text(first, std::find_if(first, last, [](char c) { return c == 'x' || c == 'X'; }));
    if (text.empty() || text.front() == '+' || std::isspace(static_cast<unsigned char>(text.front())) != 0) {
        return {first, std::errc::invalid_argument};
    }
    char *end = nullptr;
    errno = 0;
    const double read = std::strtod(text.c_str(), &end);
    const char *const stop = first + (end - text.c_str());
    if (stop == first) {
        return {first, std::errc::invalid_argument};
    }
    if (errno == ERANGE && (std::isinf(read) || read == 0)) {
        return {stop, std::errc::result_out_of_range};
    }
    value = read;
    return {stop, std::errc()};
}

#endif

} // namespace sandbox
