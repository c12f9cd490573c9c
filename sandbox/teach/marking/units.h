#pragma once

#include "teach/marking/exercise.h"

#include <cstddef>
#include <optional>
#include <vector>

/// Which pictures judge which term.
namespace sandbox {

/// A term of light, as the difference of two pictures; where `plain` is there, as the ratio to the same difference
/// without what multiplies light.
struct Part {
    struct Pair {
        Scene lit, dark;
    };
    MarkTerm carrier = MarkTerm::diffuse; ///< the term of light that shows it
    Pair shown;
    std::optional<Pair> plain;
    bool decides = true;   ///< false: it must not be wrong, but that it is right proves nothing
    bool dark_too = false; ///< the dark picture must be right as well
    /// It is judged only where this part of the answer is right: normals under a transform, by a term that is right
    /// without one.
    std::optional<Pair> needs;
};

/// What counts once: a scene with one of its lights.
struct Unit {
    std::size_t scene = 0;            ///< in exercise.scenes
    std::optional<std::size_t> light; ///< none: the scene's ambient light
    std::vector<Part> parts;
};

/// Of every term but sum and robustness; stiff scenes are left out.
std::vector<Unit> units_of(const Exercise &exercise, MarkTerm term);

/// The terms of light that the exercise asks for or, if it asks for none, all that its model has.
std::vector<MarkTerm> carriers_of(const Exercise &exercise);

/// The picture of a scene as a sum of others, each beside the dark one.
struct SumUnit {
    std::size_t scene = 0;
    Scene whole, dark;
    std::vector<std::vector<Scene>> splits; ///< by terms, by lights
};
std::vector<SumUnit> sum_units_of(const Exercise &exercise);

} // namespace sandbox
