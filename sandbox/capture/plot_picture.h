#pragma once

#include "image/image.h"
#include "measure/report/plot_layout.h"

namespace sandbox {

/// The plot and its legend as plot_file() has them, for a PNG: `scale` pixels a unit of the request.
ByteImage plot_picture(const PlotRequest &request, int scale = 2);

} // namespace sandbox
