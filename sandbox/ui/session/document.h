#pragma once

#include "image/image.h"
#include "scene/mesh_factor.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <memory>
#include <optional>
#include <string>

namespace sandbox {

/// The scene as it was opened: resets restore it.
struct OpenedScene {
    std::string name; ///< in the title and in the names of captures: "three-point-lights"
    Scene scene;
};

struct ShownStep;
struct ShownExercise;

/// All that edits change and undo restores.
struct Document {
    Scene scene;
    Technique left, right;
    /// While A is this technique, it is drawn in a textbook's float32 on the processor instead (textbook_picture()).
    std::optional<Technique> textbook;
    MeshFactors mesh_factors{1, 1}; ///< on the meshes of A and of B
    double exposure = 1;            ///< multiplies before the display transfer curve
    Display display = Display::linear;
    /// Minimum aspect: narrower views widen the field of view; 0 disables.
    double least_aspect = 1.2;
    std::shared_ptr<const OpenedScene> opened;
    std::shared_ptr<const ShownStep> step;         ///< of the lesson that is shown; null: none
    std::shared_ptr<const ShownExercise> exercise; ///< that is worked on; null: none
    bool operator==(const Document &) const = default;
    [[nodiscard]] bool left_is_textbook() const { return textbook == left; }
};

/// A document that has just been opened.
Document document_of(std::string name, const Scene &scene, const Technique &left, const Technique &right);

/// The scene as a view of this size shows it: narrow views widen the field of view.
Scene scene_in_view(const Document &document, Size view);

} // namespace sandbox
