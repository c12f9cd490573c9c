#include "ui/actions.h"

#include "ui/session/edits.h"
#include "ui/tabs/bottom_tabs.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

constexpr auto keys = Action::Group::key_only;
constexpr auto edit = Action::Group::edit;
constexpr auto lesson = Action::Group::lesson;
constexpr auto window = Action::Group::window;
constexpr int plain = 0;
constexpr int shift = GLFW_MOD_SHIFT;
constexpr int control = GLFW_MOD_CONTROL;
constexpr int no_key = -1;

std::function<void(Session &)> next_value(const TechniqueKey &key, bool right) {
    return [&key, right](Session &session) {
        Technique &technique = session.technique(right);
        set_key(technique, key, (key.get(technique) + 1) % static_cast<int>(key.values.size()));
    };
}

std::function<void(Session &)> scale_by(float factor) {
    return [factor](Session &s) { s.appearance.scale = std::clamp(s.appearance.scale * factor, 0.6F, 3.0F); };
}

Action show_layout(char key, const char *name, const char *help, Layout layout) {
    return {Action::Group::layout,
            plain,
            key,
            {key},
            name,
            help,
            [layout](Session &s) { s.view.layout = layout; },
            [layout](const Session &s) { return s.view.layout == layout; }};
}

Action switch_flag(int key, const char *shown, const char *name, bool Appearance::*flag) {
    return {window,
            plain,
            key,
            shown,
            name,
            "",
            [flag](Session &s) { s.appearance.*flag = !(s.appearance.*flag); },
            [flag](const Session &s) { return s.appearance.*flag; }};
}

void exchange_sides(Session &s) {
    std::swap(s.document.left, s.document.right);
    std::swap(s.document.mesh_factors[0], s.document.mesh_factors[1]);
}
void reset_scene(Session &s) { s.document.scene = s.document.opened->scene; }
void switch_masks(Session &s) { s.view.masks = !s.view.masks; }
void switch_loupe(Session &s) { s.view.loupe = !s.view.loupe; }
bool shows_loupe(const Session &s) { return s.view.loupe; }
bool shows_masks(const Session &s) { return s.view.masks; }
void switch_display(Session &s) {
    s.document.display = s.document.display == Display::linear ? Display::srgb : Display::linear;
}
void show_answer(Session &s) { s.answer_shown = !s.answer_shown; }
bool shows_answer(const Session &s) { return s.answer_shown; }
void ask_for_capture(Session &s) { s.requests.capture = true; }
void ask_for_window_capture(Session &s) { s.requests.capture_window = true; }
void ask_for_folder(Session &s) { s.requests.open_folder = true; }
void first_scale(Session &s) { s.appearance.scale = 1; }
void close_key_list(Session &s) { s.appearance.key_list = false; }

std::vector<Action> make_actions() {
    const auto larger = scale_by(1.1F);
    const auto smaller = scale_by(1 / 1.1F);
    const auto can_undo = [](const Session &s) { return s.history.can_undo(); };
    const auto in_lesson = [](const Session &s) { return s.document.step != nullptr && !s.appearance.key_list; };
    const auto has_answer = [](const Session &s) { return s.document.step && s.document.step->step().question; };
    const auto can_redo = [](const Session &s) { return s.history.can_redo(); };
    std::vector<Action> all{
        show_layout('1', "side by side", "A and B beside each other", Layout::side_by_side),
        show_layout('2', "wipe", "A and B in one picture; drag the divider", Layout::wipe),
        show_layout('3', "flip", "A, or B while Space is held", Layout::single),
        show_layout('4', "difference", "A - B in colours, with a scale", Layout::difference),
        show_layout('5', "with the truth", "A, B and the double-precision reference of A's model", Layout::three_up),
        {keys, plain, GLFW_KEY_F, "F", "next frequency of A", "", next_value(frequency_key, false)},
        {keys, shift, GLFW_KEY_F, "Shift+F", "next frequency of B", "", next_value(frequency_key, true)},
        {keys, plain, GLFW_KEY_M, "M", "next reflection model of A", "", next_value(model_key, false)},
        {keys, shift, GLFW_KEY_M, "Shift+M", "next reflection model of B", "", next_value(model_key, true)},
        {edit, control, GLFW_KEY_Z, "Ctrl+Z", "undo", "", undo, {}, can_undo, true},
        {edit, control | shift, GLFW_KEY_Z, "Ctrl+Shift+Z", "redo", "", redo, {}, can_redo, true},
        {keys, control, GLFW_KEY_Y, "", "redo", "", redo, {}, {}, true},
        {edit, control, GLFW_KEY_C, "Ctrl+C", "copy the scene as JSON", "",
         [](Session &s) { s.requests.copy_scene = true; }},
        {edit, control, GLFW_KEY_V, "Ctrl+V", "paste a scene", "", [](Session &s) { s.requests.paste_scene = true; }},
        {keys, control, GLFW_KEY_O, "Ctrl+O", "open a file", "", [](Session &s) { s.requests.ask_open = true; }},
        {keys, control, GLFW_KEY_S, "Ctrl+S", "save the scene", "", [](Session &s) { s.requests.ask_save = true; }},
        {edit, plain, GLFW_KEY_X, "X", "exchange A and B", "", exchange_sides},
        {edit, plain, no_key, "", "scene as opened", "", reset_scene},
        {edit, plain, GLFW_KEY_R, "R", "camera as opened", "", [](Session &s) { reset_camera(s.document); }},
        {keys, plain, GLFW_KEY_D, "D", "display linear or sRGB", "", switch_display},
        {edit, plain, GLFW_KEY_A, "A", "play the motion", "plays and pauses what the Motion tab names", play_or_pause,
         [](const Session &s) { return s.playback.playing; }},
        {keys, plain, GLFW_KEY_COMMA, ",", "a moment back", "", [](Session &s) { step_motion(s, -1); }, {}, {}, true},
        {keys, plain, GLFW_KEY_PERIOD, ".", "a moment on", "", [](Session &s) { step_motion(s, 1); }, {}, {}, true},
        {keys, plain, GLFW_KEY_F12, "F12", "capture the views as a PNG", "", ask_for_capture},
        {keys, shift, GLFW_KEY_F12, "Shift+F12", "capture the whole window", "", ask_for_window_capture},
        {lesson,
         plain,
         GLFW_KEY_PAGE_DOWN,
         "Page down",
         "the next step",
         "",
         [](Session &s) { go_on(s, 1); },
         {},
         in_lesson,
         true},
        {lesson,
         plain,
         GLFW_KEY_PAGE_UP,
         "Page up",
         "the step before",
         "",
         [](Session &s) { go_on(s, -1); },
         {},
         in_lesson,
         true},
        {lesson,
         plain,
         GLFW_KEY_HOME,
         "Home",
         "back to the step",
         "undoes what you changed in it",
         restore_step,
         {},
         step_is_changed},
        {lesson, plain, GLFW_KEY_END, "End", "the answer", "shows and hides it", show_answer, shows_answer, has_answer},
        switch_flag(GLFW_KEY_TAB, "Tab", "panels", &Appearance::panels),
        switch_flag(GLFW_KEY_F11, "F11", "full screen", &Appearance::full_screen),
        switch_flag(GLFW_KEY_T, "T", "dark", &Appearance::dark),
        {window, control, GLFW_KEY_EQUAL, "Ctrl +", "everything larger", "", larger, {}, {}, true},
        {keys, control | shift, GLFW_KEY_EQUAL, "", "everything larger", "", larger, {}, {}, true},
        {keys, control, GLFW_KEY_KP_ADD, "", "everything larger", "", larger, {}, {}, true},
        {window, control, GLFW_KEY_MINUS, "Ctrl -", "everything smaller", "", smaller, {}, {}, true},
        {keys, control, GLFW_KEY_KP_SUBTRACT, "", "everything smaller", "", smaller, {}, {}, true},
        {window, control, GLFW_KEY_0, "Ctrl 0", "everything at its first size", "", first_scale},
        switch_flag(GLFW_KEY_F1, "?  F1", "keys and mouse", &Appearance::key_list),
        {keys, plain, GLFW_KEY_ESCAPE, "", "close the list of keys", "", close_key_list},
        {window, plain, GLFW_KEY_K, "K", "masks", "the pixels that errors against the reference leave out",
         switch_masks, shows_masks},
        {window, plain, GLFW_KEY_Z, "Z", "loupe", "magnifies the pixels under the mouse in every picture", switch_loupe,
         shows_loupe},
        {window, plain, no_key, "", "open the folder of captures", "", ask_for_folder},
        {window, control, GLFW_KEY_Q, "Ctrl+Q", "quit", "", [](Session &s) { s.requests.quit = true; }},
    };
    for (const OverlayKind &kind : overlay_kinds) {
        all.push_back({window,
                       plain,
                       kind.key,
                       {kind.key},
                       std::string(kind.title),
                       std::string(kind.help),
                       [on = kind.on](Session &s) { s.view.drawn_over.*on = !(s.view.drawn_over.*on); },
                       [on = kind.on](const Session &s) { return s.view.drawn_over.*on; }});
    }
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        const BottomTab &row = bottom_tabs[tab];
        all.push_back({window,
                       plain,
                       row.key,
                       {row.key},
                       row.title,
                       "",
                       [tab](Session &s) { toggle_tab(s, tab); },
                       [tab](const Session &s) { return s.appearance.tab == tab; }});
    }
    return all;
}

} // namespace

std::span<const Action> actions() {
    static const std::vector<Action> all = make_actions();
    return all;
}

} // namespace sandbox
