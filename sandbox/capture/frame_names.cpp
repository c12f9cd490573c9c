#include "capture/frame_names.h"

#include "image/error.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

struct ExpandedPattern {
    std::string name;
    int numbers = 0;
    bool valid = true; ///< no other conversion stands in it
};

/// `pattern` with `number` for every %d and %0Nd, and a percent sign for every %%.
ExpandedPattern expand(std::string_view pattern, int number) {
    ExpandedPattern out;
    while (!pattern.empty()) {
        const bool padded = pattern.size() >= 4 && pattern.starts_with("%0") && pattern[2] >= '1' &&
                            pattern[2] <= '9' && pattern[3] == 'd';
        std::size_t length = 1;
        if (padded || pattern.starts_with("%d")) {
            out.name += fmt::format("{:0{}}", number, padded ? pattern[2] - '0' : 1);
            ++out.numbers;
            length = padded ? 4 : 2;
        } else if (pattern.starts_with("%%")) {
            out.name += '%';
            length = 2;
        } else {
            out.name += pattern.front();
            out.valid = out.valid && pattern.front() != '%';
        }
        pattern.remove_prefix(length);
    }
    return out;
}

} // namespace

double orbit_degrees(double degrees, int i, int frames) { return degrees * i / frames; }

bool is_frame_pattern(std::string_view pattern) { return expand(pattern, 0).numbers > 0; }

std::string frame_name(std::string_view pattern, int i) {
    const ExpandedPattern expanded = expand(pattern, i);
    if (!expanded.valid || expanded.numbers != 1) {
        throw InputError(
            "expected a file name with exactly one frame number such as %04d (%% for a percent sign), got '{}'",
            pattern);
    }
    return expanded.name;
}

} // namespace sandbox
