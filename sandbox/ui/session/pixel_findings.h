#pragma once

#include "reference/term_shares.h"
#include "ui/session/findings.h"
#include "ui/session/label.h"
#include "words/words.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Every intermediate of one pixel, in double, under both techniques and under the truth of each.
namespace sandbox {

struct ProbedPixel {
    PixelProbe probe;
    std::vector<TermShare> shares; ///< add up to probe.color
};

/// A and B, then the truth of A's model and that of B's.
enum class Probed { a, b, truth_of_a, truth_of_b };
constexpr std::array all_probed{Probed::a, Probed::b, Probed::truth_of_a, Probed::truth_of_b};

struct PixelFindings {
    SidesShown of;
    int x = 0, y = 0;                                                ///< row 0 at the top
    std::array<std::optional<ProbedPixel>, all_probed.size()> sides; ///< none: background, or refused
    [[nodiscard]] const std::optional<ProbedPixel> &operator[](Probed side) const {
        return sides[static_cast<std::size_t>(side)];
    }
};

/// Of A's scene and of B's.
using SideResources = std::array<std::vector<ObjectResources>, 2>;
/// Takes some tens of milliseconds.
PixelFindings probe_sides(const SidesShown &shown, const SideResources &resources, int x, int y);

/// "light 2, specular: 0.12, should be 0.61": the term of a side that is farthest from the truth; empty where none
/// differs by a level of 8 bits or more.
std::string worst_term(const Words &words, const ProbedPixel &side, const ProbedPixel &truth);

/// A table as text, for the clipboard and the window: a title and its values in A, B and the truth.
struct ProbeRow {
    Label title;
    std::array<std::string, all_probed.size()> values;
};
std::vector<ProbeRow> probe_rows(const Words &words, const PixelFindings &found);
/// The rows, tabs between the columns.
std::string probe_text(const Words &words, const PixelFindings &found);

} // namespace sandbox
