#pragma once

#include "image/image.h"
#include "measure/metrics/metrics.h"
#include "words/words.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// In place of a view: which of its pixels error figures leave out, with a legend in a lower corner.
namespace sandbox {

struct JudgedView {
    Metrics metrics;
    std::vector<PixelUse> uses; ///< of the view's pixels
};
/// `truth` is the reference of the view's technique, on its mesh.
JudgedView judge_view(const Frame &drawn, const ReferenceFrame &truth);

struct LegendLine {
    std::optional<std::array<std::uint8_t, 3>> color; ///< none: it is about the whole view
    std::string text;
};
/// How much is compared; then what each mask's colour means, how many pixels it covers, the largest error under it.
std::vector<LegendLine> mask_legend(const Words &words, const Metrics &metrics);

/// Over columns `left` to `right` (excluded) above row `bottom`, in text of `em` pixels or, where it does not fit,
/// smaller; nothing where that could not be read.
void draw_mask_legend(ByteImage &picture, const Words &words, const Metrics &metrics, int left, int right, int bottom,
                      double em, bool align_right);

} // namespace sandbox
