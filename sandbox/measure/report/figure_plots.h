#pragma once

#include "measure/metrics/profile.h"
#include "measure/report/plot_layout.h"
#include "measure/work_precision/run.h"
#include "words/words.h"

#include <optional>
#include <string>
#include <vector>

/// The plots of a hand-in, beside error_time_plot().
namespace sandbox {

struct NamedCurve {
    std::string name;
    int style = 0;
    Curve luminance;
    double width = PlotSeries{}.width; ///< of its line
};
/// Luminance over the pixels' middles; `row` is for the title.
PlotRequest profile_plot(const Words &words, int row, const std::vector<NamedCurve> &curves);

/// The ladder's rungs of a measurement of one technique (PlanOptions::only): the largest error and RMSE over the number
/// of triangles, and the slope of order 2 through the first RMSE. Nothing where no rung can be trusted.
PlotRequest subdivision_plot(const Words &words, const WorkPrecision &measured);

/// The L2 order of the last step of such a measurement; none without one.
std::optional<double> last_order(const WorkPrecision &measured);

} // namespace sandbox
