#pragma once

#include "capture/picture.h"
#include "measure/metrics/metrics.h"
#include "measure/work_precision/run.h"
#include "scene/mesh_factor.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What is found out about both sides in the background while the window rests.
namespace sandbox {

/// All that the findings depend on.
struct SidesShown {
    Scene scene; ///< as a view of this size shows it
    Technique left, right;
    bool textbook_left = false; ///< A is drawn on the processor
    Size size;                  ///< of one view
    int shaders = 0;            ///< counts reloads
    MeshFactors mesh_factors{1, 1};
    /// With that side's meshes.
    [[nodiscard]] Scene scene_of(bool right) const { return with_mesh_factor(scene, mesh_factors[right ? 1 : 0]); }
    /// What a side is judged by.
    [[nodiscard]] Technique truth_of_side(bool side_b) const {
        return side_b ? truth_of(right, left) : truth_of(left, right);
    }
    /// Have both sides the same reference?
    [[nodiscard]] bool one_truth() const {
        return truth_of_side(false) == truth_of_side(true) && mesh_factors[0] == mesh_factors[1];
    }
    bool operator==(const SidesShown &) const = default;
};

struct SideFindings {
    /// Against the reference of the side's model: every pixel, every fault off, in double precision.
    std::optional<Metrics> metrics;
    bool estimate = false;              ///< found at a quarter of the width and height
    std::shared_ptr<const Image> truth; ///< that reference, at the view's size
    std::vector<PixelUse> uses;         ///< of the view's pixels; empty: not known yet
    /// With precision=medium: what this device's own mediump changes of the side in high precision, in levels; none
    /// under OpenGL's core profile.
    std::optional<double> device;
    std::optional<RunTime> time; ///< of finished frames, taken in turns with the other side's
    std::string failure;         ///< why there is no picture
};

struct Findings {
    SidesShown of;
    std::array<SideFindings, 2> sides;
    std::optional<double> apart; ///< the largest |A - B| of any channel, infinite if a pixel is not finite
};

} // namespace sandbox
