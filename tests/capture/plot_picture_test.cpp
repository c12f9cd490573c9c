#include "capture/plot_picture.h"

#include "measure/report/paper.h"
#include "tools/pixel.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

PixelRgb as_pixel(const PaperColor &color) { return {color[0], color[1], color[2]}; }

PlotRequest request() {
    PlotRequest plot;
    plot.title = "title";
    plot.y_label = "error";
    plot.series = {{"flat", 0, {{1, 1, 1, 1, 0}, {10, 10, 10, 10, 1}}}, {"truth", style_b, {{1, 5}, {10, 5}}, true}};
    return plot;
}

/// What the layout says lies where it says, at `scale` pixels a unit; a marker's middle is whole.
TEST(PlotPicture, DrawsWhatThePlotsFileHas) {
    const PlotRequest whole = with_legend(request());
    const PlotLayout layout = lay_out(whole);
    for (const int scale : {1, 2}) {
        const ByteImage picture = plot_picture(request(), scale);
        EXPECT_EQ(picture.size, (Size{static_cast<int>(whole.width * scale), static_cast<int>(whole.height * scale)}));
        const auto at = [&](double x, double y) {
            return pixel(picture, static_cast<int>(x * scale), static_cast<int>(y * scale));
        };
        EXPECT_EQ(at(1, 1), (PixelRgb{255, 255, 255})) << "paper";
        for (const PlotPoint &point : layout.series[0].points) {
            EXPECT_EQ(at(point.x, point.y), as_pixel(paper_color("s0")));
        }
        const double middle = (layout.left + layout.right) / 2;
        EXPECT_NE(at(middle, layout.series[1].points[0].y), (PixelRgb{255, 255, 255})) << "the curve";
        const auto entries = lay_out_legend(whole, layout, legend_top(layout));
        EXPECT_EQ(at(entries[0].x + legend_line / 2, entries[0].y), as_pixel(paper_color("s0")));
    }
}

TEST(PlotPicture, TheUprightLabelReadsUpwards) {
    const ByteImage picture = plot_picture(request());
    int left = picture.size.width, top = picture.size.height, right = 0, bottom = 0;
    for (int y = 0; y < picture.size.height; ++y) {
        for (int x = 0; x < 50; ++x) { // the ticks' labels begin to the right of it
            if (pixel(picture, x, y) != PixelRgb{255, 255, 255}) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
        }
    }
    EXPECT_GT(bottom - top, 2 * (right - left)) << "five letters, one above the other";
}

} // namespace
} // namespace sandbox
