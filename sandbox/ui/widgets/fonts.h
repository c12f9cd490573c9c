#pragma once

#include <set>

struct ImFont;

namespace sandbox {

/// Fills ImGui's font atlas with a text font, a monospaced one, 16 * `scale` pixels high, and a larger one, or with
/// Dear ImGui's own font if the system has none; `rare` characters come from chinese_font(), or are drawn by
/// a page's browser. The backend's texture
/// must then be made again.
void load_fonts(float scale, const std::set<char32_t> &rare);

/// The monospaced one.
ImFont *code_font();
/// The larger one: read from the last row of a lecture hall.
ImFont *lecture_font();

} // namespace sandbox
