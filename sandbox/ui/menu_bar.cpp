#include "ui/menu_bar.h"

#include "ui/actions.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <tuple>

namespace sandbox {

namespace {

bool begin_menu(Session &session, const char *title) {
    const bool open = ImGui::BeginMenu(title);
    if (!open) { // an open one has begun a window: there is no last item
        describe_item(session, title, "");
    }
    return open;
}

void scene_menu(Session &session) {
    if (!begin_menu(session, "Scene")) {
        return;
    }
    for (const std::string &name : session.scenes) {
        const ScopedName menu(session, "Scene");
        if (ImGui::MenuItem(name.c_str(), nullptr, name == session.document.opened->name)) {
            session.requests.open = name;
        }
        describe_item(session, name, "");
    }
    ImGui::Separator();
    for (const auto &[name, key, asked] : {std::tuple("Open...", "Ctrl+O", &session.requests.ask_open),
                                           std::tuple("Save...", "Ctrl+S", &session.requests.ask_save)}) {
        const ScopedName menu(session, "Scene");
        *asked = ImGui::MenuItem(name, key) || *asked;
        describe_item(session, name, "");
    }
    ImGui::TextColored(quiet_text(), "or drop a .json, .obj or image file on the window");
    ImGui::EndMenu();
}

void action_menu(Session &session, const char *title, Action::Group group) {
    if (!begin_menu(session, title)) {
        return;
    }
    for (const Action &action : actions()) {
        if (action.group == group) {
            const ScopedName menu(session, title);
            std::string name = action.name;
            name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
            if (ImGui::MenuItem(name.c_str(), action.shown.c_str(), action.is_on && action.is_on(session),
                                !action.is_usable || action.is_usable(session))) {
                action.run(session);
            }
            describe_item(session, action.name, "");
        }
    }
    ImGui::EndMenu();
}

void language_menu(Session &session) {
    if (!begin_menu(session, "Language")) {
        return;
    }
    for (const std::string_view language : languages) {
        const ScopedName menu(session, "Language");
        const Label name = session.label(fmt::format("language.{}", language));
        if (ImGui::MenuItem(name.id().c_str(), nullptr, language == session.words.language())) {
            session.requests.language = language;
        }
        describe_item(session, name.name, "");
    }
    ImGui::EndMenu();
}

/// Of the buttons on the right.
float right_width() { return button_width("Capture") + button_width("?") + ImGui::GetStyle().ItemSpacing.x * 2; }

/// Their last words alone where there is little room: "truth" of "with the truth".
void layout_buttons(Session &session) {
    constexpr float gap = 2; // pixels
    float width = right_width();
    for (const Action &action : actions()) {
        width += action.group == Action::Group::layout ? button_width(action.name) + gap : 0;
    }
    const bool brief = ImGui::GetCursorPosX() + width > ImGui::GetWindowWidth();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0});
    for (const Action &action : actions()) {
        const std::size_t word = brief ? action.name.rfind(' ') + 1 : 0; // 0 without a space
        if (action.group == Action::Group::layout &&
            toggle_button(session, {action.name.substr(word), action.name}, action.is_on(session),
                          fmt::format("{} ({}).", action.help, action.shown))) {
            action.run(session);
        }
    }
    ImGui::PopStyleVar();
}

void right_buttons(Session &session) {
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowWidth() - right_width()));
    if (button(session, "Capture",
               "Writes the views, without the panels, as a PNG, and beside it a file that reproduces them (F12).")) {
        session.requests.capture = true;
    }
    if (button(session, "?", "Keys and mouse (F1).")) {
        session.appearance.key_list = !session.appearance.key_list;
    }
}

} // namespace

void menu_bar(Session &session) {
    if (!ImGui::BeginMainMenuBar()) {
        return;
    }
    scene_menu(session);
    action_menu(session, "Edit", Action::Group::edit);
    action_menu(session, "Window", Action::Group::window);
    language_menu(session);
    ImGui::Spacing();
    layout_buttons(session);
    right_buttons(session);
    ImGui::EndMainMenuBar();
}

} // namespace sandbox
