#pragma once

#include "capture/figure_work.h"

/// Figures that are pictures of `capture`.
namespace sandbox {

Figure pair_figure(const FigureWork &work, const Progress &progress);
/// Phong over Blinn-Phong on FigureWork::sphere.
Figure exponents_figure(const FigureWork &work, const Progress &progress);
Figure difference_figure(const FigureWork &work, const Progress &progress);

} // namespace sandbox
