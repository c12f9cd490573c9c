#pragma once

#include "image/image.h"
#include "measure/diagnosis/point_samples.h"
#include "scene/resources.h"
#include "scene/scene.h"
#include "shading/technique.h"

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

/// The pictures of one scene.
class ScenePictures {
  public:
    /// `draw` must outlive this.
    ScenePictures(Scene scene, const DiagnosisDraw &draw, const PointSamples &samples);

    [[nodiscard]] const Scene &scene() const { return scene_; }
    /// The samples of a technique's picture, drawn once and cheaply: by the program that can do every scene, which is
    /// built once, or in double where that one refuses the technique. Never null.
    const Image *samples(const Technique &technique);
    /// The whole picture by the cheap program.
    [[nodiscard]] std::optional<Image> cheap_whole(const Technique &technique) const;
    /// The whole picture by the scene's own program. Nothing where the scene refuses the technique.
    [[nodiscard]] std::optional<Image> whole(const Technique &technique) const;

  private:
    Scene scene_, sampled_;
    const DiagnosisDraw &draw_;
    PointSamples samples_;
    std::map<Technique, std::optional<Image>> drawn_;
};

/// The picture of the first of the program that can do every scene and the scene's own that takes the technique.
std::optional<Image> cheap_picture(const DiagnosisDraw &draw, const Scene &scene, Technique technique, Size size);

} // namespace sandbox
