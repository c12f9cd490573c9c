#include "capture/frame_names.h"

#include "image/error.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

/// Length of the conversion "%d" or "%0Nd" that `text` begins with; 0 if it begins with none.
std::size_t conversion_length(std::string_view text) {
    if (text.starts_with("%d")) {
        return 2;
    }
    const bool padded =
        text.size() >= 4 && text.starts_with("%0") && text[2] >= '1' && text[2] <= '9' && text[3] == 'd';
    return padded ? 4 : 0;
}

std::string padded_number(int number, std::string_view conversion) {
    return fmt::format("{:0{}}", number, conversion.size() == 4 ? conversion[2] - '0' : 1);
}

} // namespace

double orbit_degrees(double degrees, int i, int frames) { return degrees * i / frames; }

bool is_frame_pattern(std::string_view pattern) {
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern.substr(i).starts_with("%%")) {
            ++i;
        } else if (conversion_length(pattern.substr(i)) != 0) {
            return true;
        }
    }
    return false;
}

std::string frame_name(std::string_view pattern, int i) {
    std::string name;
    int conversions = 0;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::string_view rest = pattern.substr(at);
        const std::size_t length = conversion_length(rest);
        if (rest.starts_with("%%")) {
            name += '%';
            at += 2;
        } else if (length != 0) {
            name += padded_number(i, rest.substr(0, length));
            ++conversions;
            at += length;
        } else if (rest.front() == '%') {
            conversions = 0;
            break;
        } else {
            name += rest.front();
            ++at;
        }
    }
    if (conversions != 1) {
        throw InputError(fmt::format(
            "expected a file name with exactly one frame number such as %04d (%% for a percent sign), got '{}'",
            pattern));
    }
    return name;
}

} // namespace sandbox
