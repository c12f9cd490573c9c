#include "ui/session/fault_names.h"

namespace sandbox {

namespace {

struct FaultName {
    std::string_view key, value, name;
};
constexpr FaultName fault_names[]{
    {"normals", "model-matrix", "normals by the model matrix"},
    {"normals", "untransformed", "normals not transformed"},
    {"normals", "unnormalized", "normals never normalised"},
    {"normals", "cofactor", "normals of mirrored objects inverted"},
    {"normals", "view-space", "normals in view space, lights in world space"},
    {"renormalize", "off", "normals not normalised again per pixel"},
    {"position", "w0", "positions without translation (w = 0)"},
    {"position", "absolute", "positions as large float32 numbers"},
    {"gate", "view-facing", "highlights tested against the viewer (N.V)"},
    {"gate", "none", "highlights on the unlit side"},
    {"gate", "times-n-dot-l", "highlights times N.L"},
    {"facing", "view", "two-sided normals turned by N.V"},
    {"viewer", "infinite", "viewer at infinity"},
    {"half_vector", "constant", "one half vector per light"},
    {"ambient", "where-lit", "ambient light only where lit"},
    {"direction", "unnegated-diffuse", "light direction not negated"},
    {"attenuation", "interpolated", "attenuation per vertex"},
    {"attenuation", "distance-interpolated", "distance to the light per vertex"},
};

} // namespace

std::string_view fault_name(const TechniqueKey &key, int value) {
    const std::string_view word = key.values[static_cast<std::size_t>(value)].name;
    for (const FaultName &row : fault_names) {
        if (row.key == key.name && row.value == word) {
            return row.name;
        }
    }
    return "";
}

} // namespace sandbox
