#include "scene/table_read.h"

namespace sandbox {

std::string number_text(double value) {
    const double power = std::log10(std::abs(value));
    return std::abs(value) >= 1e5 && power == std::floor(power) ? fmt::format("{}1e{:.0f}", value < 0 ? "-" : "", power)
                                                                : fmt::format("{:.9g}", value);
}

std::string broken_rule(double value, const Range &range, std::string_view noun) {
    const bool low = range.above_low ? !(value > range.low) : !(value >= range.low);
    if (value == range.or_exactly || (!low && value <= range.high)) {
        return {};
    }
    if (!std::isnan(range.or_exactly)) {
        return fmt::format("{} from {} to {}, or {}", noun, number_text(range.low), number_text(range.high),
                           number_text(range.or_exactly));
    }
    if (low && (range.low == 0 || std::isinf(range.high))) {
        return fmt::format("{} {} {}", noun, range.above_low ? ">" : ">=", number_text(range.low));
    }
    if (std::isinf(range.low)) {
        return fmt::format("{} <= {}", noun, number_text(range.high));
    }
    return fmt::format("{} {} {}{} {}", noun, range.above_low ? "above" : "from", number_text(range.low),
                       range.above_low ? ", at most" : " to", number_text(range.high));
}

std::string below(const std::string &path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

std::string element(const std::string &path, std::size_t index) { return fmt::format("{}[{}]", path, index); }

} // namespace sandbox
