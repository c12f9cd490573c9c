#pragma once

#include <filesystem>
#include <optional>

struct ImFont;

namespace sandbox {

/// Text for reading and text for programs. Where the system has no such font, Dear ImGui's own, magnified.
struct Fonts {
    ImFont *text = nullptr;
    ImFont *code = nullptr;
};

/// Fills ImGui's font atlas for `scale` (1: 16 pixels). The backend's texture must be made again afterwards.
Fonts load_fonts(float scale);

} // namespace sandbox
