#pragma once

#include "ui/session/ranges.h"
#include "ui/session/session.h"

#include <glm/vec3.hpp>
#include <imgui.h>
#include <span>
#include <string>

/// Rows of a panel: a label on the left, the control on the right. Each returns true when it changed its value, is set
/// back by a right click to `opened`, takes a typed number on Ctrl+click, and says what it is in the status line.
namespace sandbox {

bool slider_row(Session &session, const char *label, double &value, double opened, const ControlRange &range,
                const char *what);
bool slider_row(Session &session, const char *label, int &value, int opened, const ControlRange &range,
                const char *what);
bool color_row(Session &session, const char *label, glm::dvec3 &value, const glm::dvec3 &opened, const char *what);
/// Three numbers; each resets alone.
bool vector_row(Session &session, const char *label, glm::dvec3 &value, const glm::dvec3 &opened,
                const ControlRange &range, const char *what);
bool switch_row(Session &session, const char *label, bool &value, bool opened, const char *what);
/// One of `names`.
bool choice_row(Session &session, const char *label, std::span<const std::string> names, std::size_t &chosen,
                const char *what);

/// Says `what` in the status line while the mouse is over the last item.
void hint_for_item(Session &session, const std::string &what);
/// The label of a row; its control comes next.
void row_label(const char *label);
/// A short heading inside a panel.
void heading(const char *text);
/// In lines no wider than the window.
void wrapped_text(const ImVec4 &color, const std::string &text);
/// An OpenGL texture's name as ImGui takes it.
ImTextureID texture_id(unsigned texture);
/// The next item on the same line if `width` still fits, else on the next one.
void same_line_if_fits(float width);
/// A button that stays pressed while `on`; true when clicked.
bool toggle_button(const char *label, bool on);

} // namespace sandbox
