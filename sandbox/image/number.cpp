#include "image/number.h"

#ifdef __EMSCRIPTEN__
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

/// strtod() reads more than from_chars(): white space and a plus before a number, and hexadecimal ones.
std::from_chars_result read_number(const char *first, const char *last, double &value) {
    const std::string text(first, last);
    const std::size_t sign = text.starts_with('-') ? 1 : 0;
    const char begin = sign < text.size() ? text[sign] : '\0';
    const bool digit = begin >= '0' && begin <= '9';
    const bool point = begin == '.' && sign + 1 < text.size() && text[sign + 1] >= '0' && text[sign + 1] <= '9';
    if (!digit && !point && begin != 'i' && begin != 'I' && begin != 'n' && begin != 'N') {
        return {first, std::errc::invalid_argument};
    }
    const bool hexadecimal = begin == '0' && (text[sign + 1] == 'x' || text[sign + 1] == 'X');
    char *end = nullptr;
    errno = 0;
    const double read = hexadecimal ? 0 : std::strtod(text.c_str(), &end);
    const char *const stop = first + (hexadecimal ? static_cast<std::ptrdiff_t>(sign) + 1 : end - text.c_str());
    if (stop == first) {
        return {first, std::errc::invalid_argument};
    }
    if (errno == ERANGE && (std::isinf(read) || read == 0)) {
        return {stop, std::errc::result_out_of_range};
    }
    value = hexadecimal && sign != 0 ? -0.0 : read;
    return {stop, std::errc()};
}

#endif

} // namespace sandbox
