#pragma once

#include "image/image.h"
#include "measure/diagnosis/conventions.h"
#include "measure/diagnosis/levels.h"
#include "measure/diagnosis/proposal.h"
#include "reference/parallel.h"
#include "reference/term_shares.h"
#include "scene/resources.h"
#include "shading/technique.h"

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a picture of a scene is: the technique, faults and conventions that draw it. Every one that is known is drawn
/// and compared; nothing is guessed. Knows no OpenGL.
namespace sandbox {

/// right: no fault and no convention is needed; named: one explanation; tied: several that look alike here.
enum class Verdict { right, named, tied, unknown };
inline constexpr std::array<std::string_view, 4> verdict_words{"right", "named", "tied", "unknown"};

/// A pixel and what makes its colour.
struct TellingPixel {
    int x = 0, y = 0;                          ///< row 0 at the top
    glm::dvec3 picture{0}, named{0}, right{0}; ///< levels of 8 bits, as the picture has them
    /// Of the explanation and of the same technique without faults, in linear colour; empty for the background.
    std::vector<TermShare> named_terms, right_terms;
};

/// What the program that drew the picture draws in the proposed scene, held against the technique and its ties.
struct SecondLook {
    std::vector<Technique> remaining; ///< those that explain it there, too
    std::string error;                ///< why it could not be drawn there; else empty
};

struct Diagnosis {
    Verdict verdict = Verdict::unknown;
    /// Few faults first, then the one that is nearest; of an unknown picture the nearest that is known.
    Technique technique;
    /// All others, of as few faults, whose picture differs from that of `technique` by at most one level at every
    /// compared pixel; settings without effect are left out.
    std::vector<Technique> ties;
    std::vector<Convention> conventions;
    Difference residual;          ///< after the explanation, at the compared pixels
    std::size_t shown_pixels = 0; ///< that show an object
    /// Did only some pixels have to be compared (edges, jumps, silhouettes left out, as `compare` does)? A picture that
    /// is explained everywhere owes no mask.
    bool masked = false;
    TellingPixel pixel;
    std::optional<Proposal> proposal; ///< what would tell the ties apart
    /// Where the request can draw it and no convention changes the scene's light.
    std::optional<SecondLook> after_proposal;
    Image expected;             ///< the explanation, in the numbers of the picture's file
    std::size_t candidates = 0; ///< pictures that were drawn to be compared
};

/// One explanation of at most as many faults; see diagnose().
struct DiagnosisRequest {
    Scene scene;
    Observed observed;
    /// Frequency, model and variants that are known (of the model `own`: the frequency alone); none: all are searched.
    std::optional<Technique> technique;
    /// Where ties may be told apart: of a later list only if nothing in the earlier ones tells any.
    std::vector<std::vector<TrialScene>> trials;
    /// Draws another scene by the program that drew `observed`, at the same size, to look a second time. Empty: it is
    /// out of reach. Throws InputError where it cannot.
    std::function<Observed(const Scene &)> redraw;
};

/// The picture has the size of the request's. Throws Cancelled.
Diagnosis diagnose(const DiagnosisRequest &request, const DiagnosisDraw &draw, const Progress &progress = {});

} // namespace sandbox
