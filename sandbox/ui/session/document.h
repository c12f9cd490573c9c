#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <memory>
#include <optional>
#include <string>

namespace sandbox {

/// The scene as it was opened: what "reset" goes back to.
struct OpenedScene {
    std::string name; ///< as it is shown and as captures are named: "three-point-lights"
    Scene scene;
};

/// All that an edit can change and undo brings back.
struct Document {
    Scene scene;
    Technique left, right;
    /// While A is this technique, it is drawn in a textbook's float32 on the processor instead (textbook_picture()).
    std::optional<Technique> textbook;
    double exposure = 1; ///< multiplies before the display transfer curve
    Display display = Display::linear;
    /// Narrower views see as much from left to right as a picture of this aspect; 0: just the scene's angle of view.
    double least_aspect = 1.2;
    std::shared_ptr<const OpenedScene> opened;
    bool operator==(const Document &) const = default;
    [[nodiscard]] bool left_is_textbook() const { return textbook == left; }
};

/// A document as a scene is first seen.
Document document_of(std::string name, const Scene &scene, const Technique &left, const Technique &right);

/// The scene as a view of this size shows it: its angle of view widened where the view is narrow.
Scene scene_in_view(const Document &document, Size view);

} // namespace sandbox
