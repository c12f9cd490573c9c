#pragma once

#include "scene/scene.h"

namespace sandbox {

/// Window depth as the logarithm of the distance along the view, 0 at near and 1 at far: at_1 + per_octave * log2(d).
/// Of deep scenes (shading/length_scale.h), whose near and far are too far apart for z / w.
struct LogDepth {
    double per_octave, at_1;
};

/// `scale`: what the program's lengths are multiplied by (Placing).
LogDepth log_depth(const Camera &camera, double scale);

/// The share of its distance that a wireframe's line must come nearer, so that the surface it lies on does not hide
/// it: the line's pixels lie up to half a pixel beside it, where a surface seen at up to 86 degrees from its normal is
/// nearer by tan(86 degrees) = 14 times that.
double line_lift(const Camera &camera, int picture_height);

} // namespace sandbox
