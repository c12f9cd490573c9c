#pragma once

#include "scene/scene_format.h"
#include "ui/session/session.h"

#include <array>
#include <imgui.h>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sandbox {

/// What a row of a panel says, and the numbers it takes.
struct Row {
    Label label; ///< with its unit; no two rows of a panel have the same name
    Range range;
    std::string hint; ///< whole sentences
};

/// Rows of a panel: a label on the left, the control on the right. Each returns true when it changed its value. A right
/// click resets the value to `opened`, Ctrl+click takes a typed number, and the status line says what the row is for.
bool control_row(Session &session, const Row &row, double &value, double opened);
bool control_row(Session &session, const Row &row, int &value, int opened);
bool control_row(Session &session, const Row &row, bool &value, bool opened);
bool control_row(Session &session, const Row &row, glm::dvec2 &value, const glm::dvec2 &opened);
/// A colour or a vector, as the range says. Each number of a vector resets alone.
bool control_row(Session &session, const Row &row, glm::dvec3 &value, const glm::dvec3 &opened);
bool control_row(Session &session, const Row &row, std::array<glm::dvec3, 2> &value,
                 const std::array<glm::dvec3, 2> &opened);
bool choice_row(Session &session, const Label &label, std::span<const Label> choices, std::size_t &chosen,
                const std::string &hint);

/// Of a row or a widget whose hint is the text KEY.help.
Row row_of(const Session &session, std::string_view key, const Range &range);

/// Controls without a label, each with its hint.
/// A list that opens, called `name`; true if another of `choices` was chosen.
bool combo(Session &session, const std::string &name, std::span<const Label> choices, std::size_t &chosen,
           const std::string &hint);
bool button(Session &session, const Label &label, const std::string &hint);
bool small_button(Session &session, const Label &label, const std::string &hint);
bool checkbox(Session &session, const Label &label, bool &on, const std::string &hint);
bool radio_button(Session &session, const Label &label, bool on, const std::string &hint);
/// A button that stays pressed while `on`.
bool toggle_button(Session &session, const Label &label, bool on, const std::string &hint);
/// The edge of a panel, over `size` of the current window, upright if it is higher than wide: where along its way it
/// is moved to, in window coordinates, by the mouse or, while it has the keys, by arrows. A right click, a double click
/// and Enter set `chosen` to 0.
std::optional<float> panel_edge(Session &session, std::string_view name, ImVec2 size, float &chosen,
                                const std::string &hint);
/// The thickness of an edge.
float edge_thickness();
/// The slider alone: as wide as the next item, over the usual part of the range and as far as `opened`.
bool slider(Session &session, const Row &row, double &value, double opened);

/// The last item: what scripts call it, the hint that the status line shows while the mouse is over it, the text that
/// it shows, if that is not its name, and the number.
void describe_item(Session &session, std::string_view name, const std::string &hint, std::string text = {},
                   std::optional<double> value = {});
/// As describe_item() does, for text that was drawn from `low` to `high`.
void describe_text(Session &session, std::string_view name, ImVec2 low, ImVec2 high, std::string text);
/// The label of a row; its control comes next.
void row_label(const std::string &label);
/// A short heading inside a panel.
void heading(std::string_view text);
/// In lines no wider than the window.
void wrapped_text(const ImVec4 &color, const std::string &text);
/// Likewise, for a lecture hall. Scripts call it `name`.
void large_text(Session &session, const char *name, const std::string &text);
/// An OpenGL texture's name as ImGui takes it.
ImTextureID texture_id(unsigned texture);
/// The way back.
unsigned texture_name(ImTextureID id);
/// Arrows, Page up and down, Home and End scroll the current window, which has nothing to choose, while it has the
/// keys.
void scroll_by_keys();
/// Went the key down in this frame, or does it repeat?
bool is_key_pressed(ImGuiKey key);
/// Puts the next item on the same line if `width` still fits there.
void same_line_if_fits(float width);
/// The width of a button with this label.
float button_width(const std::string &label);

/// While it lives, ImGui's names of items belong to `id`.
struct ScopedId {
    explicit ScopedId(const std::string &id) { ImGui::PushID(id.c_str()); }
    explicit ScopedId(std::size_t id) { ImGui::PushID(static_cast<int>(id)); }
    ~ScopedId() { ImGui::PopID(); }
    ScopedId(const ScopedId &) = delete;
    ScopedId &operator=(const ScopedId &) = delete;
};

/// As ScopedId; scripts' names, too, begin with `name`.
class ScopedName {
  public:
    ScopedName(Session &session, const std::string &name) : session_(session), id_(name) {
        session.widgets.enter(name);
    }
    ~ScopedName() { session_.widgets.leave(); }
    ScopedName(const ScopedName &) = delete;
    ScopedName &operator=(const ScopedName &) = delete;

  private:
    Session &session_;
    ScopedId id_;
};

} // namespace sandbox
