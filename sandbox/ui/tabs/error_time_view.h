#pragma once

#include "measure/report/work_precision_plot.h"
#include "ui/session/session.h"

#include <array>
#include <imgui.h>

/// The parts of the tab "Error vs run time" that show a measurement. A click on a row, as a point or in the table,
/// takes it into A, a right click or Shift+click into B.
namespace sandbox {

struct ErrorTimeView {
    Model model = Model::blinn_phong;
    ErrorNorm norm = ErrorNorm::rmse;
    std::array<bool, all_frequencies.size()> hidden{}; ///< by series
};

/// Model and norm, on one line; `narrow`: as lists that open instead of buttons.
void error_time_choices(Session &session, const WorkPrecision &measured, ErrorTimeView &view, bool narrow);

/// Name and marker of every series; a click hides it or shows it again.
void error_time_legend(Session &session, ErrorTimeView &view);

/// The plot, `size` large, in the current ImGui window.
void error_time_figure(Session &session, const WorkPrecision &measured, const ErrorTimeView &view, ImVec2 size);

/// The cheapest technique within each tolerance.
void cheapest_table(Session &session, const WorkPrecision &measured, const ErrorTimeView &view);

} // namespace sandbox
