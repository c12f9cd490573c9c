#pragma once

#include "capture/marks.h"
#include "scene/assets.h"
#include "scene/mesh_factor.h"
#include "scene/overlays.h"
#include "ui/session/session.h"

#include <filesystem>
#include <optional>
#include <string>

namespace sandbox {

/// What the window takes from a built-in name, a scene file, a model or a capture's sidecar.
struct OpenedFile {
    std::string name; ///< in the title and in the names of captures
    Scene scene;
    bool capture = false; ///< a sidecar, which also sets what follows
    std::optional<Technique> left, right;
    bool textbook_left = false;
    std::optional<MeshFactors> mesh_factors;
    std::optional<Display> display;
    std::optional<double> exposure;
    std::optional<Layout> layout;
    std::optional<double> divider; ///< of a wipe
    std::optional<Overlays> drawn_over;
    std::optional<bool> masks;
    std::optional<Marks> marks;
    std::optional<double> gain; ///< of a difference, as is:
    std::optional<DifferenceOf> difference_of;
};

/// Throws InputError.
OpenedFile open_file(const std::string &name_or_path, const Assets &assets);
/// Likewise, where `scene` is the file's with settings of its own.
OpenedFile open_file(const std::string &name_or_path, const Assets &assets, Scene scene);

/// Does a file's name say that it is a picture, as textures are?
bool is_image_name(const std::filesystem::path &path);

/// A scene or a sidecar as text, from the clipboard. Throws InputError.
OpenedFile open_text(const std::string &text);

/// The document to show; what the file does not set stays as it is in `session`.
Document document_from(const OpenedFile &file, const Session &session);
/// Likewise for how the two pictures are shown.
void take_view(ViewSettings &view, const OpenedFile &file);

} // namespace sandbox
