#include "measure/report/text.h"

#include <cmath>

namespace sandbox {

std::string short_number(double value) {
    if (std::isnan(value)) {
        return "none";
    }
    if (!std::isfinite(value)) {
        return "not finite";
    }
    if (value == 0) {
        return "0";
    }
    const double size = std::abs(value);
    if (size < 1e-3 || size >= 1e5) {
        return fmt::format("{:.2e}", value);
    }
    const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : size >= 0.01 ? 4 : 5;
    return fmt::format("{:.{}f}", value, decimals);
}

std::string milliseconds_text(double value) {
    return fmt::format("{:.{}f}", value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

std::string mesh_words(const PlannedMesh &mesh) {
    return mesh.ladder ? fmt::format("{} rings{}", mesh.rings, mesh.own ? " (the scene's own)" : "")
                       : "the scene's own mesh";
}

std::string short_mesh_words(const PlannedMesh &mesh) {
    return mesh.ladder ? fmt::format("{} rings", mesh.rings) : "own mesh";
}

std::string bound_name(double bound) { return bound == 1e-5 ? "1e-5" : fmt::format("1/{}", std::lround(1 / bound)); }

} // namespace sandbox
