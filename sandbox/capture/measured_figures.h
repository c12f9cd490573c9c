#pragma once

#include "capture/figure_work.h"

/// Figures with plots of what is measured.
namespace sandbox {

/// Throws Cancelled, as error_time_figure() does.
Figure subdivision_figure(const FigureWork &work, const Progress &progress);
Figure profile_figure(const FigureWork &work, const Progress &progress);
/// Of A's model.
Figure error_time_figure(const FigureWork &work, const Progress &progress);

} // namespace sandbox
