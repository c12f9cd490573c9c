#include "ui/frame.h"

#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

struct Mode {
    ViewMode mode;
    const char *name, *hint;
};
constexpr Mode modes[] = {
    {ViewMode::side_by_side, "side by side", "A and B beside each other (1)."},
    {ViewMode::wipe, "wipe", "A over B; drag the divider (2)."},
    {ViewMode::flip, "flip", "A; hold Space to see B in its place (3)."},
    {ViewMode::difference, "difference", "A - B in colours, with a scale (4)."},
};

void scene_menu(Session &session) {
    if (!ImGui::BeginMenu("Scene")) {
        return;
    }
    for (const std::string &name : session.scenes) {
        if (ImGui::MenuItem(name.c_str(), nullptr, name == session.document.opened->name)) {
            session.requests.open = name;
        }
    }
    ImGui::Separator();
    ImGui::TextColored(quiet_text(), "or drop a .json or .obj file on the window");
    ImGui::EndMenu();
}

void edit_menu(Session &session) {
    if (!ImGui::BeginMenu("Edit")) {
        return;
    }
    if (ImGui::MenuItem("Undo", "Ctrl+Z", false, session.history.can_undo())) {
        undo(session);
    }
    if (ImGui::MenuItem("Redo", "Ctrl+Shift+Z", false, session.history.can_redo())) {
        redo(session);
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Exchange A and B", "X")) {
        std::swap(session.document.left, session.document.right);
    }
    if (ImGui::MenuItem("Scene as opened")) {
        session.document.scene = session.document.opened->scene;
    }
    ImGui::EndMenu();
}

void window_menu(Session &session) {
    if (!ImGui::BeginMenu("Window")) {
        return;
    }
    Appearance &look = session.appearance;
    if (ImGui::MenuItem("Dark", "T", look.dark)) {
        look.dark = true;
    }
    if (ImGui::MenuItem("Light", "T", !look.dark)) {
        look.dark = false;
    }
    ImGui::Separator();
    ImGui::MenuItem("Panels", "Tab", &look.panels);
    if (ImGui::MenuItem("Error vs run time", "E", look.tab == BottomTab::error_time)) {
        toggle_tab(session, BottomTab::error_time);
    }
    if (ImGui::MenuItem("GLSL", "G", look.tab == BottomTab::glsl)) {
        toggle_tab(session, BottomTab::glsl);
    }
    if (ImGui::MenuItem("Stability", "S", look.tab == BottomTab::stability)) {
        toggle_tab(session, BottomTab::stability);
    }
    ImGui::MenuItem("Full screen", "F11", &look.full_screen);
    ImGui::Separator();
    ImGui::TextColored(quiet_text(), "Ctrl + and Ctrl - scale everything");
    if (ImGui::MenuItem("Quit", "Ctrl+Q")) {
        session.requests.quit = true;
    }
    ImGui::EndMenu();
}

void view_buttons(Session &session) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2, 0});
    for (const Mode &mode : modes) {
        if (toggle_button(mode.name, session.view.mode == mode.mode)) {
            session.view.mode = mode.mode;
        }
        hint_for_item(session, mode.hint);
    }
    ImGui::PopStyleVar();
}

void right_buttons(Session &session) {
    const float padding = ImGui::GetStyle().FramePadding.x * 2;
    const float width = ImGui::CalcTextSize("Capture").x + ImGui::CalcTextSize("?").x + padding * 2 +
                        ImGui::GetStyle().ItemSpacing.x * 2;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowWidth() - width));
    if (ImGui::Button("Capture")) {
        session.requests.capture = true;
    }
    hint_for_item(session, "Writes the views, without the panels, as a PNG and what it was made from beside it (F12).");
    if (ImGui::Button("?")) {
        session.appearance.key_list = !session.appearance.key_list;
    }
    hint_for_item(session, "Keys and mouse (F1).");
}

} // namespace

void menu_bar(Session &session) {
    if (!ImGui::BeginMainMenuBar()) {
        return;
    }
    scene_menu(session);
    edit_menu(session);
    window_menu(session);
    ImGui::Spacing();
    view_buttons(session);
    right_buttons(session);
    ImGui::EndMainMenuBar();
}

} // namespace sandbox
