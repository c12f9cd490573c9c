#include "ui/keys.h"

#include "ui/actions.h"
#include "ui/widgets/theme.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

namespace {

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
    const auto found = std::ranges::find_if(actions(), [&](const Action &action) {
        return action.key == key && action.mods == held && (!repeated || action.repeats);
    });
    if (found != actions().end() && (!typing || while_typing)) {
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
        for (const Action &action : actions()) {
            if (!action.shown.empty()) {
                const char *colon = action.help.empty() ? "" : ": ";
                help_line(action.shown, fmt::format("{}{}{}", action.name, colon, action.help));
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
