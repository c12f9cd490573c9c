#pragma once

#include "reference/reference.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace sandbox {

/// What one term of one light adds to a pixel, as its technique brings it there: under per-vertex interpolated between
/// the corners. The shares of a pixel add up to its colour.
struct TermShare {
    std::optional<std::size_t> light; ///< in scene.lights; none: the scene's ambient light and emission
    std::string_view term;            ///< "ambient", "diffuse" or "specular"
    glm::dvec3 color{0};
};

/// Of pixel (x, y), row 0 at the top; empty for the background. One probe a term: some milliseconds each. Throws as
/// render_reference does.
std::vector<TermShare> term_shares(const Scene &scene, const std::vector<ObjectResources> &resources,
                                   const Technique &technique, Size size, int x, int y);

inline constexpr std::array<std::string_view, 3> term_names{"ambient", "diffuse", "specular"};
/// What one of term_names adds along row y, 0 at the top, summed over the lights; "ambient" holds the scene's ambient
/// light and emission, too. A row's three terms add up to its colours; 0 for the background.
std::vector<glm::dvec3> term_row(const Scene &scene, const std::vector<ObjectResources> &resources,
                                 const Technique &technique, Size size, int y, std::string_view term);

} // namespace sandbox
