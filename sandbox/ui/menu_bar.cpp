#include "ui/frame.h"

#include "ui/keys.h"
#include "ui/tabs/bottom_tabs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <utility>

namespace sandbox {

namespace {

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
    ImGui::MenuItem("Dark", "T", &look.dark);
    ImGui::Separator();
    ImGui::MenuItem("Panels", "Tab", &look.panels);
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        const BottomTab &row = bottom_tabs[tab];
        if (ImGui::MenuItem(row.title, std::string(1, row.key).c_str(), look.tab == tab)) {
            toggle_tab(session, tab);
        }
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
    for (const LayoutChoice &choice : layout_choices) {
        if (toggle_button(choice.name, session.view.layout == choice.layout)) {
            session.view.layout = choice.layout;
        }
        hint_for_item(session, fmt::format("{} ({}).", choice.help, choice.key));
    }
    ImGui::PopStyleVar();
}

void right_buttons(Session &session) {
    const float width = button_width("Capture") + button_width("?") + ImGui::GetStyle().ItemSpacing.x * 2;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowWidth() - width));
    if (ImGui::Button("Capture")) {
        session.requests.capture = true;
    }
    hint_for_item(session,
                  "Writes the views, without the panels, as a PNG, and beside it a file that reproduces them (F12).");
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
