#include "ui/actions.h"

#include "ui/session/edits.h"
#include "ui/tabs/bottom_tabs.h"
#include "words/row_words.h"

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

using Said = std::function<std::string(const Words &)>;
Said said(const std::string &key) {
    return [key](const Words &words) { return words.text(key); };
}

Action show_layout(char key, const std::string &word, Layout layout) {
    return {Action::Group::layout,
            plain,
            key,
            {key},
            said("layout." + word),
            said("layout." + word + ".help"),
            [layout](Session &s) { s.view.layout = layout; },
            [layout](const Session &s) { return s.view.layout == layout; },
            {},
            false,
            said("layout." + word + ".brief")};
}

Action switch_flag(int key, const char *shown, const std::string &word, bool Appearance::*flag) {
    return {window,
            plain,
            key,
            shown,
            said("action." + word),
            {},
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
        show_layout('1', "side_by_side", Layout::side_by_side),
        show_layout('2', "wipe", Layout::wipe),
        show_layout('3', "single", Layout::single),
        show_layout('4', "difference", Layout::difference),
        show_layout('5', "three_up", Layout::three_up),
        {keys, plain, GLFW_KEY_F, "F", said("action.next_frequency_a"), {}, next_value(frequency_key, false)},
        {keys, shift, GLFW_KEY_F, "Shift+F", said("action.next_frequency_b"), {}, next_value(frequency_key, true)},
        {keys, plain, GLFW_KEY_M, "M", said("action.next_model_a"), {}, next_value(model_key, false)},
        {keys, shift, GLFW_KEY_M, "Shift+M", said("action.next_model_b"), {}, next_value(model_key, true)},
        {edit, control, GLFW_KEY_Z, "Ctrl+Z", said("action.undo"), {}, undo, {}, can_undo, true},
        {edit, control | shift, GLFW_KEY_Z, "Ctrl+Shift+Z", said("action.redo"), {}, redo, {}, can_redo, true},
        {keys, control, GLFW_KEY_Y, "", said("action.redo"), {}, redo, {}, {}, true},
        {edit,
         control,
         GLFW_KEY_C,
         "Ctrl+C",
         said("action.copy_scene"),
         {},
         [](Session &s) { s.requests.copy_scene = true; }},
        {edit,
         control,
         GLFW_KEY_V,
         "Ctrl+V",
         said("action.paste_scene"),
         {},
         [](Session &s) { s.requests.paste_scene = true; }},
        {keys,
         control,
         GLFW_KEY_O,
         "Ctrl+O",
         said("action.open_file"),
         {},
         [](Session &s) { s.requests.ask_open = true; }},
        {keys,
         control,
         GLFW_KEY_S,
         "Ctrl+S",
         said("action.save_scene"),
         {},
         [](Session &s) { s.requests.ask_save = true; }},
        {edit, plain, GLFW_KEY_X, "X", said("action.exchange"), {}, exchange_sides},
        {edit, plain, no_key, "", said("action.reset_scene"), {}, reset_scene},
        {edit, plain, GLFW_KEY_R, "R", said("action.reset_camera"), {}, [](Session &s) { reset_camera(s.document); }},
        {keys, plain, GLFW_KEY_D, "D", said("action.switch_display"), {}, switch_display},
        {edit, plain, GLFW_KEY_A, "A", said("action.play"), said("action.play.help"), play_or_pause,
         [](const Session &s) { return s.playback.playing; }},
        {keys,
         plain,
         GLFW_KEY_COMMA,
         ",",
         said("action.moment_back"),
         {},
         [](Session &s) { step_motion(s, -1); },
         {},
         {},
         true},
        {keys,
         plain,
         GLFW_KEY_PERIOD,
         ".",
         said("action.moment_on"),
         {},
         [](Session &s) { step_motion(s, 1); },
         {},
         {},
         true},
        {keys, plain, GLFW_KEY_F12, "F12", said("action.capture"), {}, ask_for_capture},
        {keys, shift, GLFW_KEY_F12, "Shift+F12", said("action.capture_window"), {}, ask_for_window_capture},
        {lesson,
         plain,
         GLFW_KEY_PAGE_DOWN,
         "Page down",
         said("action.next_step"),
         {},
         [](Session &s) { go_on(s, 1); },
         {},
         in_lesson,
         true},
        {lesson,
         plain,
         GLFW_KEY_PAGE_UP,
         "Page up",
         said("action.step_before"),
         {},
         [](Session &s) { go_on(s, -1); },
         {},
         in_lesson,
         true},
        {lesson,
         plain,
         GLFW_KEY_HOME,
         "Home",
         said("action.restore_step"),
         said("action.restore_step.help"),
         restore_step,
         {},
         step_is_changed},
        {lesson, plain, GLFW_KEY_END, "End", said("action.answer"), said("action.answer.help"), show_answer,
         shows_answer, has_answer},
        switch_flag(GLFW_KEY_TAB, "Tab", "panels", &Appearance::panels),
        switch_flag(GLFW_KEY_F11, "F11", "full_screen", &Appearance::full_screen),
        switch_flag(GLFW_KEY_T, "T", "dark", &Appearance::dark),
        {window, control, GLFW_KEY_EQUAL, "Ctrl +", said("action.larger"), {}, larger, {}, {}, true},
        {keys, control | shift, GLFW_KEY_EQUAL, "", said("action.larger"), {}, larger, {}, {}, true},
        {keys, control, GLFW_KEY_KP_ADD, "", said("action.larger"), {}, larger, {}, {}, true},
        {window, control, GLFW_KEY_MINUS, "Ctrl -", said("action.smaller"), {}, smaller, {}, {}, true},
        {keys, control, GLFW_KEY_KP_SUBTRACT, "", said("action.smaller"), {}, smaller, {}, {}, true},
        {window, control, GLFW_KEY_0, "Ctrl 0", said("action.first_size"), {}, first_scale},
        switch_flag(GLFW_KEY_F1, "?  F1", "key_list", &Appearance::key_list),
        {keys, plain, GLFW_KEY_ESCAPE, "", said("action.close_keys"), {}, close_key_list},
        {window, plain, GLFW_KEY_K, "K", said("action.masks"), said("action.masks.help"), switch_masks, shows_masks},
        {window, plain, GLFW_KEY_Z, "Z", said("action.loupe"), said("action.loupe.help"), switch_loupe, shows_loupe},
#ifdef __EMSCRIPTEN__
        {edit, plain, GLFW_KEY_U, "U", said("action.copy_link"), said("action.copy_link.help"),
         [](Session &s) { s.requests.copy_link = true; }},
        {window, plain, no_key, "", said("action.licences"), {}, [](Session &s) { s.requests.show_licences = true; }},
#else
        {window, plain, no_key, "", said("action.open_folder"), {}, ask_for_folder},
        {window, control, GLFW_KEY_Q, "Ctrl+Q", said("action.quit"), {}, [](Session &s) { s.requests.quit = true; }},
#endif
    };
    for (const OverlayKind &kind : overlay_kinds) {
        all.push_back({window,
                       plain,
                       kind.key,
                       {kind.key},
                       [kind](const Words &words) { return title_of(words, kind); },
                       [kind](const Words &words) { return help_of(words, kind); },
                       [on = kind.on](Session &s) { s.view.drawn_over.*on = !(s.view.drawn_over.*on); },
                       [on = kind.on](const Session &s) { return s.view.drawn_over.*on; }});
    }
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        const BottomTab &row = bottom_tabs[tab];
        all.push_back({window,
                       plain,
                       row.key,
                       {row.key},
                       said(title_key(row)),
                       {},
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

Label label_of(const Session &session, const Action &action) {
    return {action.name(session.words), action.name(session.words.english())};
}
std::string help_of(const Session &session, const Action &action) {
    return action.help ? action.help(session.words) : std::string();
}

} // namespace sandbox
