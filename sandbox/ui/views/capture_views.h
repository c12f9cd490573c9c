#pragma once

#include "capture/sidecar.h"
#include "ui/session/session.h"
#include "ui/views/view_painter.h"

#include <filesystem>

namespace sandbox {

/// Writes the picture and its sidecar; returns where. Throws InputError.
std::filesystem::path capture_views(const Session &session, ViewPainter &painter, const DrawnBy &by);

} // namespace sandbox
