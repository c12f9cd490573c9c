#pragma once

#include "teach/marking/exercise.h"
#include "teach/marking/marker.h"

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace sandbox {

/// The right pictures of one exercise, in double, and where they are compared: worked out once, for all answers.
class Truth {
  public:
    /// Both must outlive this.
    Truth(const Exercise &exercise, const MarkDraw &draw);
    Truth(const Truth &) = delete;
    Truth &operator=(const Truth &) = delete;

    [[nodiscard]] PictureStore &pictures() { return pictures_; }
    /// Of a scene, what `compare` compares: edges, jumps, silhouettes and what rounding decides are left out.
    const std::vector<std::uint8_t> &compared(const Scene &scene);
    [[nodiscard]] ComparedPixels masks() {
        return [this](const Scene &scene) -> const std::vector<std::uint8_t> & { return compared(scene); };
    }

  private:
    Image draw_truth(const Scene &scene);
    const std::vector<std::uint32_t> &ids(const Scene &scene);

    const Exercise &exercise_;
    const MarkDraw &draw_;
    PictureStore pictures_;
    std::deque<std::pair<Scene, std::vector<std::uint8_t>>> masks_; ///< a deque: they stay where they are
    std::deque<std::pair<Scene, std::vector<std::uint32_t>>> ids_;  ///< of scenes without lights
};

} // namespace sandbox
