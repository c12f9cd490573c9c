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

bool begin_menu(Session &session, const Label &title) {
    const bool open = ImGui::BeginMenu(title.id().c_str());
    if (!open) { // an open one has begun a window: there is no last item
        describe_item(session, title.name, "", title.shown);
    }
    return open;
}

void scene_menu(Session &session) {
    const Label title = session.label("menu.scene");
    if (!begin_menu(session, title)) {
        return;
    }
    for (const std::string &name : session.scenes) {
        const ScopedName menu(session, title.name);
        if (ImGui::MenuItem(name.c_str(), nullptr, name == session.document.opened->name)) {
            session.requests.open = name;
        }
        describe_item(session, name, "");
    }
    ImGui::Separator();
    for (const auto &[text, key, asked] : {std::tuple("menu.open", "Ctrl+O", &session.requests.ask_open),
                                           std::tuple("menu.save", "Ctrl+S", &session.requests.ask_save)}) {
        const ScopedName menu(session, title.name);
        const Label name = session.label(text);
        *asked = ImGui::MenuItem(name.id().c_str(), key) || *asked;
        describe_item(session, name.name, "", name.shown);
    }
    ImGui::TextColored(quiet_text(), "%s", session.text("menu.drop").c_str());
    ImGui::EndMenu();
}

void action_items(Session &session, const Label &title, Action::Group group) {
    for (const Action &action : actions()) {
        if (action.group == group) {
            const ScopedName menu(session, title.name);
            Label name = label_of(session, action);
            name.shown.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.shown.front())));
            if (ImGui::MenuItem(name.id().c_str(), action.shown.c_str(), action.is_on && action.is_on(session),
                                !action.is_usable || action.is_usable(session))) {
                action.run(session);
            }
            describe_item(session, name.name, "", name.shown);
        }
    }
}

void action_menu(Session &session, const Label &title, Action::Group group) {
    if (begin_menu(session, title)) {
        action_items(session, title, group);
        ImGui::EndMenu();
    }
}

void lesson_items(Session &session, const Label &title, bool bugs) {
    const std::string shown = session.document.step ? session.document.step->id : "";
    for (const ListedLesson &lesson : session.lessons) {
        if (lesson.bug == bugs) {
            const ScopedName menu(session, title.name);
            if (ImGui::MenuItem(Label(lesson.title, lesson.name).id().c_str(), nullptr, lesson.name == shown)) {
                session.requests.open_lesson = lesson.name;
            }
            describe_item(session, lesson.name, "", lesson.title);
        }
    }
}

void exercise_items(Session &session, const Label &title) {
    const std::string shown = session.document.exercise ? session.document.exercise->id : "";
    for (const ListedExercise &exercise : session.exercises) {
        const ScopedName menu(session, title.name);
        if (ImGui::MenuItem(Label(exercise.title, exercise.name).id().c_str(), nullptr, exercise.name == shown)) {
            session.requests.open_exercise = exercise.name;
        }
        describe_item(session, exercise.name, "", exercise.title);
    }
}

void lesson_menu(Session &session) {
    const Label title = session.label("menu.lesson");
    if (!begin_menu(session, title)) {
        return;
    }
    lesson_items(session, title, false);
    if (begin_menu(session, session.label("menu.bugs"))) {
        lesson_items(session, title, true);
        ImGui::EndMenu();
    }
    if (begin_menu(session, session.label("menu.exercises"))) {
        exercise_items(session, title);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    action_items(session, title, Action::Group::lesson);
    const Label open = session.label("menu.open_lesson");
    session.requests.ask_open = ImGui::MenuItem(open.id().c_str(), "Ctrl+O") || session.requests.ask_open;
    ImGui::EndMenu();
}

void language_menu(Session &session) {
    const Label title = session.label("menu.language");
    if (!begin_menu(session, title)) {
        return;
    }
    for (const std::string_view language : languages) {
        const ScopedName menu(session, title.name);
        const Label name = session.label(fmt::format("language.{}", language));
        if (ImGui::MenuItem(name.id().c_str(), nullptr, language == session.words.language())) {
            session.requests.language = language;
        }
        describe_item(session, name.name, "", name.shown);
    }
    ImGui::EndMenu();
}

/// Of the buttons on the right.
float right_width(const Session &session) {
    return button_width(session.text("menu.capture")) + button_width("?") + ImGui::GetStyle().ItemSpacing.x * 2;
}

/// Briefly where there is little room.
void layout_buttons(Session &session) {
    constexpr float gap = 2; // pixels
    float width = right_width(session);
    for (const Action &action : actions()) {
        width += action.group == Action::Group::layout ? button_width(label_of(session, action).shown) + gap : 0;
    }
    const bool brief = ImGui::GetCursorPosX() + width > ImGui::GetWindowWidth();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0});
    for (const Action &action : actions()) {
        if (action.group != Action::Group::layout) {
            continue;
        }
        const Label whole = label_of(session, action);
        const Label shown{brief ? action.brief(session.words) : whole.shown, whole.name};
        if (toggle_button(session, shown, action.is_on(session),
                          session.text("hint.key", help_of(session, action), action.shown))) {
            action.run(session);
        }
    }
    ImGui::PopStyleVar();
}

void right_buttons(Session &session) {
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowWidth() - right_width(session)));
    if (button(session, session.label("menu.capture"), session.text("menu.capture.help"))) {
        session.requests.capture = true;
    }
    if (button(session, "?", session.text("menu.keys.help"))) {
        session.appearance.key_list = !session.appearance.key_list;
    }
}

/// All that has no room beside the first menus.
void more_menu(Session &session) {
    action_menu(session, session.label("menu.views"), Action::Group::layout);
    const Label title = session.label("menu.more");
    if (!begin_menu(session, title)) {
        return;
    }
    action_menu(session, session.label("menu.edit"), Action::Group::edit);
    action_menu(session, session.label("menu.window"), Action::Group::window);
    language_menu(session);
    const Label capture = session.label("menu.capture");
    session.requests.capture = ImGui::MenuItem(capture.id().c_str()) || session.requests.capture;
    describe_item(session, capture.name, "", capture.shown);
    ImGui::EndMenu();
}

} // namespace

void menu_bar(Session &session) {
    if (!ImGui::BeginMainMenuBar()) {
        return;
    }
    scene_menu(session);
    lesson_menu(session);
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    if (is_upright(window.x, window.y, ImGui::GetFontSize())) {
        more_menu(session);
    } else {
        action_menu(session, session.label("menu.edit"), Action::Group::edit);
        action_menu(session, session.label("menu.window"), Action::Group::window);
        language_menu(session);
        ImGui::Spacing();
        layout_buttons(session);
        right_buttons(session);
    }
    ImGui::EndMainMenuBar();
}

} // namespace sandbox
