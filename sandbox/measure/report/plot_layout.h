#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Lays out plots: numbers become positions, y downwards, in the unit of `width`. Draws nothing, so that a page and a
/// window show the same plot.
namespace sandbox {

enum class Scale { linear, logarithmic };

struct PlotPoint {
    double x = 0, y = 0;
    double x_low = 0, x_high = 0; ///< the spread of x; equal: none
    std::size_t tag = 0;          ///< set by the caller: its row
};
struct PlotSeries {
    std::string name;
    int style = 0; ///< set by the caller: colour and marker
    std::vector<PlotPoint> points;
    bool curve = false; ///< a line alone, without markers
    double width = 1.8; ///< of its line
};
struct PlotGuide {
    double y = 0;
    std::string label;
};
struct PlotRequest {
    std::string title, x_label, y_label;
    Scale x_scale = Scale::logarithmic, y_scale = Scale::logarithmic;
    double width = 520, height = 380;
    double left = 62, right = 14, top = 30, bottom = 46; ///< margins
    std::vector<double> x_marks;                         ///< the ticks of x; none: round numbers
    std::vector<double> y_shown;                         ///< what the axis of y holds, whatever the series have
    std::vector<PlotSeries> series;
    std::vector<std::size_t> front;      ///< tags of the points on the front, by x
    std::vector<PlotGuide> guides;       ///< horizontal; those out of range are left out
    std::string front_name;              ///< in a legend
    double x_room = 0.06, y_room = 0.06; ///< left free on either side, as shares of the span
};

struct PlotTick {
    double at = 0;
    std::string label; ///< empty: a minor one
};
/// The request's series and guides, with positions in place of numbers.
struct PlotLayout {
    double left = 0, top = 0, right = 0, bottom = 0; ///< the frame
    std::vector<PlotTick> x_ticks, y_ticks;
    std::vector<PlotSeries> series;
    std::vector<PlotPoint> front; ///< the corners of its staircase
    std::vector<PlotGuide> guides;
};

/// Points that are not finite, or not positive on a logarithmic scale, are left out.
PlotLayout lay_out(const PlotRequest &request);

/// A legend's entry: 30 units of its line from (x, y) to the right, then its name.
struct LegendEntry {
    std::optional<int> style; ///< none: the front's
    bool curve = false;
    double width = 0; ///< of its line
    std::string name;
    double x = 0, y = 0;
};
/// Of what `layout` shows, in rows from (layout.left, top) within the frame's width.
std::vector<LegendEntry> lay_out_legend(const PlotRequest &request, const PlotLayout &layout, double top);
constexpr double plot_text = 12, legend_row = 19, legend_line = 30;
/// The request with a bottom margin that holds its legend, and where that begins.
PlotRequest with_legend(PlotRequest request);
double legend_top(const PlotLayout &layout);

/// The tag of the point nearest to (x, y), if one lies within `reach`.
std::optional<std::size_t> nearest_point(const PlotLayout &layout, double x, double y, double reach);

/// The corners (x, y) of a series' marker of radius 1, clockwise; empty: a circle. Series differ by form as well as by
/// colour.
std::span<const std::pair<double, double>> marker_corners(int style);

/// Horizontal bars, each divided by the shares of its parts.
struct Bar {
    std::vector<double> parts; ///< >= 0
};
struct BarPiece {
    std::size_t bar = 0, part = 0;
    double x = 0, y = 0, width = 0, height = 0;
};
/// Bars below each other from (left, top), each `width` wide, one every `step`; parts that are 0 have no piece.
std::vector<BarPiece> lay_out_shares(const std::vector<Bar> &bars, double left, double top, double width, double step,
                                     double thickness);

} // namespace sandbox
