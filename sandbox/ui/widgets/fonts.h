#pragma once

struct ImFont;

namespace sandbox {

/// Fills ImGui's font atlas with a text font and a monospaced one, 16 * `scale` pixels high, or with Dear ImGui's own
/// font if the system has none. The backend's texture must then be made again.
void load_fonts(float scale);

/// The monospaced one.
ImFont *code_font();

} // namespace sandbox
