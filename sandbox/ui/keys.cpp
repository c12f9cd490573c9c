#include "ui/keys.h"

#include "ui/session/edits.h"
#include "ui/tabs/bottom_tabs.h"
#include "ui/widgets/theme.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

constexpr int plain = 0;
constexpr int shift = GLFW_MOD_SHIFT;
constexpr int control = GLFW_MOD_CONTROL;

void next_value(Session &session, const TechniqueKey &key, bool right) {
    Technique &technique = session.technique(right);
    set_key(technique, key, (key.get(technique) + 1) % static_cast<int>(key.values.size()));
}

template <bool Right> void next_frequency(Session &s) { next_value(s, frequency_key, Right); }
template <bool Right> void next_model(Session &s) { next_value(s, model_key, Right); }

void scale_by(Session &s, float factor) { s.appearance.scale = std::clamp(s.appearance.scale * factor, 0.6F, 3.0F); }

struct Shortcut {
    int mods, key;
    std::string shown; ///< empty: another way to the one above
    std::string help;
    std::function<void(Session &)> run;
    bool repeats = false;
};

std::vector<Shortcut> make_shortcuts() {
    const auto larger = [](Session &s) { scale_by(s, 1.1F); };
    const auto smaller = [](Session &s) { scale_by(s, 1 / 1.1F); };
    std::vector<Shortcut> shortcuts;
    for (const LayoutChoice &choice : layout_choices) {
        shortcuts.push_back(
            {plain, choice.key, {choice.key}, fmt::format("{}: {}", choice.name, choice.help), [&choice](Session &s) {
                 s.view.layout = choice.layout;
             }});
    }
    for (std::size_t tab = 0; tab < std::size(bottom_tabs); ++tab) {
        const BottomTab &row = bottom_tabs[tab];
        shortcuts.push_back({plain, row.key, {row.key}, row.title, [tab](Session &s) { toggle_tab(s, tab); }});
    }
    shortcuts.insert(
        shortcuts.end(),
        {
            {plain, GLFW_KEY_F, "F", "next frequency of A", next_frequency<false>},
            {shift, GLFW_KEY_F, "Shift+F", "next frequency of B", next_frequency<true>},
            {plain, GLFW_KEY_M, "M", "next reflection model of A", next_model<false>},
            {shift, GLFW_KEY_M, "Shift+M", "next reflection model of B", next_model<true>},
            {plain, GLFW_KEY_X, "X", "exchange A and B",
             [](Session &s) { std::swap(s.document.left, s.document.right); }},
            {plain, GLFW_KEY_W, "W", "wireframe", [](Session &s) { s.view.wireframe = !s.view.wireframe; }},
            {plain, GLFW_KEY_D, "D", "display linear or sRGB",
             [](Session &s) {
                 s.document.display = s.document.display == Display::linear ? Display::srgb : Display::linear;
             }},
            {plain, GLFW_KEY_R, "R", "camera as opened", [](Session &s) { reset_camera(s.document); }},
            {control, GLFW_KEY_Z, "Ctrl+Z", "undo", undo, true},
            {control | shift, GLFW_KEY_Z, "Ctrl+Shift+Z", "redo", redo, true},
            {control, GLFW_KEY_Y, "", "", redo, true},
            {plain, GLFW_KEY_F12, "F12", "capture the views as a PNG", [](Session &s) { s.requests.capture = true; }},
            {plain, GLFW_KEY_TAB, "Tab", "hide or show the panels",
             [](Session &s) { s.appearance.panels = !s.appearance.panels; }},
            {plain, GLFW_KEY_F11, "F11", "full screen",
             [](Session &s) { s.appearance.full_screen = !s.appearance.full_screen; }},
            {control, GLFW_KEY_EQUAL, "Ctrl +", "everything larger", larger, true},
            {control | shift, GLFW_KEY_EQUAL, "", "", larger, true},
            {control, GLFW_KEY_KP_ADD, "", "", larger, true},
            {control, GLFW_KEY_MINUS, "Ctrl -", "everything smaller", smaller, true},
            {control, GLFW_KEY_KP_SUBTRACT, "", "", smaller, true},
            {control, GLFW_KEY_0, "Ctrl 0", "everything at its first size", [](Session &s) { s.appearance.scale = 1; }},
            {plain, GLFW_KEY_T, "T", "dark or light", [](Session &s) { s.appearance.dark = !s.appearance.dark; }},
            {plain, GLFW_KEY_F1, "?  F1", "this list",
             [](Session &s) { s.appearance.key_list = !s.appearance.key_list; }},
            {plain, GLFW_KEY_ESCAPE, "", "", [](Session &s) { s.appearance.key_list = false; }},
            {control, GLFW_KEY_Q, "Ctrl+Q", "quit", [](Session &s) { s.requests.quit = true; }},
        });
    return shortcuts;
}

const std::vector<Shortcut> &shortcuts() {
    static const std::vector<Shortcut> made = make_shortcuts();
    return made;
}

struct MouseHelp {
    const char *shown, *help;
};
constexpr MouseHelp mouse_help[] = {
    {"drag", "orbit around the target"},
    {"right drag", "move across the picture"},
    {"wheel", "closer, farther"},
    {"double click", "camera as opened"},
    {"Ctrl+click", "type a slider's number"},
    {"right click", "back to the scene's value"},
    {"drop a file", "open a scene, a model or a capture's .json"},
};

void help_line(const std::string &shown, const std::string &help) {
    ImGui::TextColored(side_color(false), "%s", shown.c_str());
    ImGui::SameLine(ImGui::GetFontSize() * 7.5F);
    ImGui::TextUnformatted(help.c_str());
}

} // namespace

int layout_key(int key, int scancode) {
    const bool printable = key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
    const char *name = printable && key != GLFW_KEY_SPACE ? glfwGetKeyName(key, scancode) : nullptr;
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') {
        return key;
    }
    const char c = name[0];
    return c >= 'a' && c <= 'z' ? GLFW_KEY_A + (c - 'a') : c >= '!' && c <= '`' ? c : key;
}

void press_key(Session &session, int key, int mods, bool repeated, bool typing) {
    const int held = mods & (GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER);
    const bool while_typing = key == GLFW_KEY_Q || (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25);
    const auto found = std::ranges::find_if(shortcuts(), [&](const Shortcut &shortcut) {
        return shortcut.key == key && shortcut.mods == held && (!repeated || shortcut.repeats);
    });
    if (found != shortcuts().end() && (!typing || while_typing)) {
        found->run(session);
    }
}

void key_list(Session &session) {
    if (!session.appearance.key_list) {
        return;
    }
    const ImGuiViewport &window = *ImGui::GetMainViewport();
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.WorkSize.x, window.WorkSize.y - ImGui::GetFrameHeight()});
    ImGui::SetNextWindowPos(window.GetWorkCenter(), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;
    if (ImGui::Begin("Keys and mouse", &session.appearance.key_list, flags)) {
        ImGui::BeginGroup();
        for (const Shortcut &shortcut : shortcuts()) {
            if (!shortcut.shown.empty()) {
                help_line(shortcut.shown, shortcut.help);
            }
        }
        ImGui::EndGroup();
        ImGui::SameLine(0, ImGui::GetFontSize() * 2);
        ImGui::BeginGroup();
        for (const MouseHelp &line : mouse_help) {
            help_line(line.shown, line.help);
        }
        ImGui::EndGroup();
    }
    ImGui::End();
}

} // namespace sandbox
