#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace sandbox {

/// The pictures of scenes, each drawn once; all of one size.
class PictureStore {
  public:
    using Draw = std::function<Image(const Scene &)>;
    explicit PictureStore(Draw draw) : draw_(std::move(draw)) {}

    /// Throws what drawing it throws.
    const Image &of(const Scene &scene) {
        for (const auto &[known, image] : drawn_) {
            if (known == scene) {
                return *image;
            }
        }
        return *drawn_.emplace_back(scene, std::make_unique<Image>(draw_(scene))).second;
    }
    [[nodiscard]] std::size_t count() const { return drawn_.size(); }

  private:
    Draw draw_;
    std::vector<std::pair<Scene, std::unique_ptr<Image>>> drawn_; ///< pointers: a picture stays where it is
};

/// 1 where a pixel of a scene's picture is compared with the truth.
using ComparedPixels = std::function<const std::vector<std::uint8_t> &(const Scene &)>;

} // namespace sandbox
