#pragma once

#include "teach/marking/kinds.h"
#include "teach/marking/picture_store.h"
#include "teach/marking/units.h"

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

/// Judges an answer term by term, from its pictures and those of the truth. Knows neither how they are drawn nor what
/// is known of faults.
namespace sandbox {

/// Where a term is farthest from the truth.
struct WorstPixel {
    std::size_t scene = 0;          ///< in exercise.scenes
    int x = 0, y = 0;               ///< row 0 at the top
    glm::dvec3 answer{0}, truth{0}; ///< linear colour of the term alone; of attenuation and cones, the factor
    ErrorKind kind = ErrorKind::shape;
    bool factor = false; ///< of attenuation and cones
};

/// Of `units` pictures, `right` are right.
struct TermResult {
    MarkTerm term = MarkTerm::diffuse;
    std::size_t units = 0, right = 0; ///< units 0: nothing shows it
    std::optional<WorstPixel> worst;
    bool spared = false; ///< wrong, but by the fault of another term, which has paid

    /// From 0 to 1.
    [[nodiscard]] double share() const;
    [[nodiscard]] bool is_right() const { return units > 0 && right == units; }
};

struct Judgement {
    std::vector<TermResult> terms; ///< as the exercise lists them
    [[nodiscard]] double points(const Exercise &exercise) const;
    [[nodiscard]] TermResult *find(MarkTerm term);
};

/// Differences of the same parts of two sides.
struct Compared {
    enum class State { right, wrong, nothing };
    State state = State::nothing;
    double error = 0; ///< the largest
    std::size_t pixel = 0;
    glm::dvec3 left{0}, right{0}; ///< there
    ErrorKind kind = ErrorKind::shape;
    bool factor = false; ///< they are ratios
};

/// Who is judged, by whom.
struct Sides {
    PictureStore &answer, &truth;
    ComparedPixels compared;
    bool forgives_nonfinite = false; ///< pixels that are not finite cost another term
};

/// At most this share of the pixels that show a part may be off: single pixels where float32 decides otherwise.
constexpr double stray_share = 0.002;

Compared compare_part(const Part &part, const Sides &sides, double tolerance, bool forgive_dark = false);

/// Does the answer show the part as `sides.truth` does, which need not be the truth here? Nothing where too few pixels
/// show it, or most are not finite. Light above white may differ in its last digits.
std::optional<bool> parts_agree(const Part &part, const Sides &sides, double tolerance);

/// Throws what drawing throws.
Judgement judge(const Exercise &exercise, const Sides &sides);

/// A result to share of two digits after the point, so that sums are what is shown.
double points_of(const TermPoints &term, const TermResult &result);

} // namespace sandbox
