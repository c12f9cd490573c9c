#include "capture/masks.h"

#include "image/cut_paste.h"
#include "image/text.h"
#include "measure/report/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sandbox {

namespace {

constexpr double smallest_text = 6;                     // pixels
constexpr double line = 1.25, margin = 0.5, swatch = 1; // in text heights

double width_of(const std::vector<LegendLine> &legend, double em) {
    double widest = 0;
    for (const LegendLine &each : legend) {
        widest = std::max(widest, text_width(each.text, em) + (each.color ? (swatch + margin) * em : 0));
    }
    return widest + 2 * margin * em;
}

} // namespace

JudgedView judge_view(const Frame &drawn, const ReferenceFrame &truth) {
    return {compare(drawn, truth, Flip::without), pixel_uses(drawn.object_ids, truth)};
}

std::vector<LegendLine> mask_legend(const Words &words, const Metrics &metrics) {
    const double share = metrics.compared_share;
    std::vector<LegendLine> legend{
        {{}, std::isnan(share) ? words.text("mask.nothing") : words.format("mask.compared", 100 * share)}};
    for (const Mask &mask : masks) {
        const std::size_t pixels = metrics.*mask.pixels;
        const std::string name = title_of(words, mask);
        legend.push_back({mask.color, pixels == 0 ? words.format("mask.none", name)
                                                  : words.format("mask.pixels", name, pixels, metrics.*mask.max_abs)});
    }
    return legend;
}

void draw_mask_legend(ByteImage &picture, const Words &words, const Metrics &metrics, int left, int right, int bottom,
                      double em, bool align_right) {
    const std::vector<LegendLine> legend = mask_legend(words, metrics);
    const auto height = [&] { return (line * static_cast<double>(legend.size()) + margin) * em; };
    while (em >= smallest_text && (width_of(legend, em) > right - left || height() > bottom / 2.0)) {
        em *= 0.95;
    }
    if (em < smallest_text) {
        return;
    }
    const int width = static_cast<int>(std::ceil(width_of(legend, em)));
    const int from = align_right ? right - width : left;
    double y = bottom - std::ceil(height());
    fill_part(picture, from, static_cast<int>(y), from + width, bottom, {16, 18, 22});
    y += margin * em / 2;
    for (const LegendLine &each : legend) {
        double x = from + margin * em;
        if (each.color) {
            fill_part(picture, static_cast<int>(x), static_cast<int>(y + 0.1 * em), static_cast<int>(x + swatch * em),
                      static_cast<int>(y + 1.1 * em), *each.color);
            x += (swatch + margin) * em;
        }
        draw_text(picture, x, y, em, each.text, {240, 240, 240});
        y += line * em;
    }
}

} // namespace sandbox
