#pragma once

#include "image/image.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What half precision costs a scene, and which values of the program must be declared highp to get it back.
namespace sandbox {

/// Levels are 8-bit ones of linear light as displayed; infinite where a picture is not finite.
struct PrecisionFinding {
    Technique technique;           ///< with precision=high
    double rounded = 0;            ///< what precision=medium changes, at most, in levels
    std::optional<double> device;  ///< what this device's own mediump changes; none under OpenGL's core profile
    std::vector<std::string> high; ///< with these highp (by kept_names) a level at most is left, without any more
    double left = 0;               ///< in levels
};

/// The largest difference of any channel of any pixel.
double levels_between(const Image &a, const Image &b);

/// Searches the twin's picture (reference/medium_stage.h), `size` large: from all values high it takes one after the
/// other away and keeps those without which more than a level is wrong, again until none can be taken away.
PrecisionFinding find_precision(const Scene &scene, const std::vector<ObjectResources> &resources,
                                const Technique &technique, Size size);

} // namespace sandbox
