#include "capture/figures.h"

#include "capture/figure_work.h"
#include "capture/figures_page.h"
#include "image/error.h"
#include "tools/english.h"

#include <gtest/gtest.h>
#include <limits>

namespace sandbox {
namespace {

TEST(Figures, TheGainIs125AndBringsTheLargestNearTheEnd) {
    EXPECT_EQ(fitting_gain(0.6), 1);
    EXPECT_EQ(fitting_gain(1), 1);
    EXPECT_EQ(fitting_gain(0.4), 2);
    EXPECT_EQ(fitting_gain(0.2), 5);
    EXPECT_DOUBLE_EQ(fitting_gain(0.09), 10);
    EXPECT_DOUBLE_EQ(fitting_gain(3e-6), 2e5);
    EXPECT_DOUBLE_EQ(fitting_gain(8), 0.1);
    EXPECT_EQ(fitting_gain(0), 1);
    EXPECT_EQ(fitting_gain(std::numeric_limits<double>::infinity()), 1);
    EXPECT_EQ(fitting_gain(unmeasured), 1);
}

TEST(Figures, ARowHasLargestAndRmseInLevels) {
    Metrics metrics;
    metrics.norms.max_abs = 0.4;
    metrics.norms.rmse = 0.02;
    metrics.max_levels = 101;
    EXPECT_EQ(table_row(with_error_cells({"A"}, metrics)), "| A | 0.400 | 101 | 0.0200 | 5.10 |\n");
    EXPECT_EQ(table_head(with_error_heads(english, {"x"})),
              "| x | largest error | levels | RMSE | levels |\n|---|---:|---:|---:|---:|\n");
    settle(metrics = {}); // nothing is compared
    EXPECT_EQ(table_row(with_error_cells({"A"}, metrics)), "| A | none | none | none | none |\n");
}

TEST(Figures, RefuseSizesThatLeaveNoRoom) {
    EXPECT_NO_THROW(check_figure_size({640, 480}));
    EXPECT_NO_THROW(check_figure_size({32, 32}));
    EXPECT_THROW(check_figure_size({31, 480}), InputError);
    EXPECT_THROW(check_figure_size({8000, 32}), InputError);
}

/// A plot is shown as SVG with its PNG beside it, a picture as PNG; all files are linked, once each.
TEST(Figures, ThePageShowsThemInTheirOrder) {
    FigureRequest request;
    request.name = "one.json";
    request.scene.name = "One *ball*";
    request.scene.description = "Look at `it`.";
    request.scene_arguments = "one.json --set 'ambient=[1,1,1]'";
    request.common_arguments = " --assets mine";
    request.folder = "out";
    request.words = english;
    FigureDraw draw;
    draw.by = {"a renderer", "3.3"};
    const std::vector<Figure> figures{{"First. ",
                                       "What is seen. ",
                                       "| a |\n|---|\n",
                                       {"first command", "second command"},
                                       {{"a.png", ""}, {"a.png.json", ""}}},
                                      {"Second. ", "More.", "", {}, {{"b.svg", ""}, {"b.png", ""}}}};
    const std::string page = figures_page(request, draw, figures);
    EXPECT_TRUE(page.starts_with("# Figures: One \\*ball\\*\n\nLook at \\`it\\`.\n\n")) << page;
    EXPECT_NE(page.find("```sh\nshading-sandbox figures one.json --set 'ambient=[1,1,1]' --assets mine --out out\n```"),
              std::string::npos);
    EXPECT_NE(page.find("![Figure 1.](a.png)\n\n**Figure 1.** First. What is seen.\n\n| a |\n|---|\n\nFiles: "
                        "[a.png](a.png), [a.png.json](a.png.json)\n\n```sh\nfirst command\nsecond command\n```\n"),
              std::string::npos)
        << page;
    EXPECT_TRUE(page.ends_with(
        "\n![Figure 2.](b.svg)\n\n**Figure 2.** Second. More.\n\nFiles: [b.svg](b.svg), [b.png](b.png)\n"))
        << page;
}

} // namespace
} // namespace sandbox
