#pragma once

#include "scene/assets.h"
#include "ui/session/session.h"

#include <optional>
#include <string>

namespace sandbox {

/// What a built-in name, a scene file, a model or a capture's sidecar brings into the window.
struct OpenedFile {
    std::string name; ///< as shown and as captures are named
    Scene scene;
    bool capture = false; ///< a sidecar: what follows is there
    std::optional<Technique> left, right;
    bool textbook_left = false;
    std::optional<Display> display;
    std::optional<double> exposure;
    std::optional<ViewMode> mode;
    std::optional<double> divider; ///< of a wipe
};

/// Throws InputError.
OpenedFile open_file(const std::string &name_or_path, const Assets &assets);

/// The document to show; what the file does not say stays as it is in `session`.
Document document_from(const OpenedFile &file, const Session &session);
/// The same for how the two pictures are shown.
void take_view(ViewSettings &view, const OpenedFile &file);

} // namespace sandbox
