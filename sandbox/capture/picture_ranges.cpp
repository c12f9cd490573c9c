#include "capture/picture_ranges.h"

#include "image/error.h"
#include "scene/table_read.h"

#include <cmath>

namespace sandbox {

double checked_number(double value, const Range &range) {
    const std::string broken = std::isfinite(value) ? broken_rule(value, range, "a number") : "a finite number";
    if (!broken.empty()) {
        throw InputError("expected {}, got {:g}", broken, value);
    }
    return value;
}

} // namespace sandbox
