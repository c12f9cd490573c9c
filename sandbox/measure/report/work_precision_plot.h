#pragma once

#include "measure/report/plot_layout.h"
#include "measure/work_precision/findings.h"

#include <string>
#include <vector>

/// Error against run time as a plot: what report.html and the window show of a measurement.
namespace sandbox {

/// The techniques of a plot, in the order of its series; a series' style is its place here.
constexpr Frequency plotted_frequencies[]{Frequency::flat, Frequency::per_vertex, Frequency::per_pixel,
                                          Frequency::interpolated_vectors, Frequency::hybrid};
std::vector<std::string> plotted_names();
int series_style(Frequency frequency);

/// The base rows of one model: one line a frequency, coarse meshes first, with the front and the tolerances. A point's
/// tag is its row.
PlotRequest error_time_plot(const WorkPrecision &measured, Model model, ErrorNorm norm);

} // namespace sandbox
