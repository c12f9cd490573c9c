#pragma once

#include "measure/report/plot_layout.h"
#include "words/words.h"

#include <functional>
#include <string>
#include <vector>

/// Plots as inline SVG. Colours come from the page's style: classes s0, s1, ... for series, p0, p1, ... for parts.
namespace sandbox {

/// `tip(tag)` is the text that shows when the mouse rests on a point.
std::string plot_svg(const PlotRequest &request, const std::function<std::string(std::size_t)> &tip);

/// A file of its own: the plot over its legend in explicit colours on white, for any program that shows SVG.
std::string plot_file(const PlotRequest &request);

/// The legend: line, marker and name of every series; `with_front`: of the front, too.
std::string legend_html(const Words &words, const std::vector<std::string> &names, bool with_front);

struct LabelledBar {
    std::string label, value, tip;
    Bar bar;
    bool gap_above = false; ///< begins a new group
};
std::string bars_svg(const std::vector<LabelledBar> &bars, double width, const std::string &title);

} // namespace sandbox
