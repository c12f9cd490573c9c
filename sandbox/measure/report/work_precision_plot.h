#pragma once

#include "measure/report/plot_layout.h"
#include "measure/work_precision/findings.h"

#include <string>
#include <vector>

/// Error against run time as a plot: what report.html and the window show of a measurement.
namespace sandbox {

/// A plot has a series a frequency, in the order of all_frequencies; its style is its number there.
std::vector<std::string> series_names();
constexpr int series_style(Frequency frequency) { return static_cast<int>(frequency); }

/// The base rows of one model: one line a frequency, coarse meshes first, with the front and the tolerances. A point's
/// tag is its row.
PlotRequest error_time_plot(const WorkPrecision &measured, Model model, ErrorNorm norm);

} // namespace sandbox
