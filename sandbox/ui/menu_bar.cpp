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

void action_items(Session &session, const char *title, Action::Group group) {
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
}

void action_menu(Session &session, const char *title, Action::Group group) {
    if (begin_menu(session, title)) {
        action_items(session, title, group);
        ImGui::EndMenu();
    }
}

void lesson_items(Session &session, bool bugs) {
    const std::string shown = session.document.step ? session.document.step->id : "";
    for (const ListedLesson &lesson : session.lessons) {
        if (lesson.bug == bugs) {
            const ScopedName menu(session, "Lesson");
            if (ImGui::MenuItem(lesson.title.c_str(), nullptr, lesson.name == shown)) {
                session.requests.open_lesson = lesson.name;
            }
            describe_item(session, lesson.name, "", lesson.title);
        }
    }
}

void lesson_menu(Session &session) {
    if (!begin_menu(session, "Lesson")) {
        return;
    }
    lesson_items(session, false);
    if (begin_menu(session, "Famous bugs")) {
        lesson_items(session, true);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    action_items(session, "Lesson", Action::Group::lesson);
    session.requests.ask_open = ImGui::MenuItem("Open a lesson file...", "Ctrl+O") || session.requests.ask_open;
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
    lesson_menu(session);
    action_menu(session, "Edit", Action::Group::edit);
    action_menu(session, "Window", Action::Group::window);
    language_menu(session);
    ImGui::Spacing();
    layout_buttons(session);
    right_buttons(session);
    ImGui::EndMainMenuBar();
}

} // namespace sandbox
