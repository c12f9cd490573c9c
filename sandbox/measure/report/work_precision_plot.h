#pragma once

#include "measure/report/plot_layout.h"
#include "measure/work_precision/findings.h"
#include "words/words.h"

#include <string>
#include <vector>

/// Error against run time as a plot: what report.html and the window show of a measurement.
namespace sandbox {

/// A plot has one series per frequency, in the order of all_frequencies; its number there is its style.
std::vector<std::string> series_names(const Words &words);
constexpr int series_style(Frequency frequency) { return static_cast<int>(frequency); }

/// The base rows of one model: one line per frequency, coarse meshes first, with the front and the tolerances. A
/// point's tag is its row.
PlotRequest error_time_plot(const Words &words, const WorkPrecision &measured, Model model, ErrorNorm norm);

} // namespace sandbox
