#pragma once

#include <imgui.h>

namespace sandbox {

/// Colours and spacing for dark or light rooms, both at high contrast; `scale` 1 is for 16-pixel text.
void apply_theme(bool dark, float scale);

/// A window so narrow and high that panels stand below the pictures: a phone's.
bool is_upright(float width, float height, float text_height);

/// Colours of the theme in use:
ImVec4 quiet_text();     ///< headings, what is less important
ImVec4 error_text();     ///< what went wrong
ImVec4 text_on_accent(); ///< on pressed buttons
/// A's orange or B's blue, wherever A and B are named; a difference has the colour of the brighter one.
ImVec4 side_color(bool right);
/// Of the techniques in a plot, and of the front below them: as in report.html.
ImVec4 series_color(int style);
ImVec4 front_color();

} // namespace sandbox
