#pragma once

#include "image/image.h"
#include "measure/diagnosis/point_samples.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace sandbox {

/// How a diagnosis is drawn: by the renderer, or by a fake in a test.
struct DiagnosisDraw {
    std::function<std::vector<ObjectResources>(const Scene &)> load;
    /// Of that size; the last argument: with object ids. Throws InputError where the scene refuses the technique.
    std::function<Frame(const Scene &, const Technique &, Size, bool)> picture;
};

/// Draws with render/'s Renderer, which this room cannot name and which must outlive what is returned.
template <typename Renderer> DiagnosisDraw diagnosis_drawn_by(Renderer &renderer) {
    return {[&](const Scene &scene) { return renderer.resources().load(scene); },
            [&](const Scene &scene, const Technique &technique, Size size, bool object_ids) {
                return renderer.render(scene, technique, size, object_ids);
            }};
}

/// Draws the samples of pictures of one size. To build the program that can do every scene takes as long as some
/// hundred such pictures in double: a frequency is drawn in double at first, by that program once much has been drawn,
/// and always in double where it refuses the technique.
class Sampler {
  public:
    /// `draw` must outlive this.
    Sampler(const DiagnosisDraw &draw, const PointSamples &samples) : draw_(draw), samples_(samples) {}

    [[nodiscard]] const DiagnosisDraw &draw() const { return draw_; }
    [[nodiscard]] const PointSamples &samples() const { return samples_; }
    /// `scene` has the camera of the samples.
    Image drawn(const Scene &scene, const Technique &technique);

  private:
    const DiagnosisDraw &draw_;
    PointSamples samples_;
    std::array<std::size_t, all_frequencies.size()> triangles_{}; ///< drawn in double
};

/// The pictures of one scene.
class ScenePictures {
  public:
    /// `sampler` must outlive this.
    ScenePictures(Scene scene, Sampler &sampler);

    [[nodiscard]] const Scene &scene() const { return scene_; }
    /// ... under the camera of the samples.
    [[nodiscard]] const Scene &sampled_scene() const { return sampled_; }
    /// The samples of a technique's picture, drawn once.
    const Image &samples(const Technique &technique);
    /// The whole picture by the cheap program.
    [[nodiscard]] std::optional<Image> cheap_whole(const Technique &technique) const;
    /// The whole picture by the scene's own program. Nothing where the scene refuses the technique.
    [[nodiscard]] std::optional<Image> whole(const Technique &technique) const;

  private:
    Scene scene_, sampled_;
    Sampler &sampler_;
    std::map<Technique, Image> drawn_;
};

/// The picture of the first of the program that can do every scene and the scene's own that takes the technique.
std::optional<Image> cheap_picture(const DiagnosisDraw &draw, const Scene &scene, Technique technique, Size size);

} // namespace sandbox
