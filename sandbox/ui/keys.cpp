#include "ui/keys.h"

#include "ui/actions.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <imgui.h>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

/// A line of the list; a heading has no key.
struct HelpLine {
    std::string shown, help;
};
const HelpLine keyboard_help[] = {
    {"", "Panels by keyboard"},
    {"Ctrl+Tab", "to another panel or the menu bar"},
    {"arrows", "to another control; Home, End, Page up and down"},
    {"Space", "press; into a list"},
    {"Enter", "type a number; Escape: leave"},
    {"arrows", "on a panel's edge: move it; Enter: back"},
};
const HelpLine mouse_help[] = {
    {"", "Mouse"},
    {"drag", "orbit around the target"},
    {"drag a light", "move it, or turn it by its tip or tail"},
    {"right drag", "move across the picture"},
    {"wheel", "closer, farther"},
    {"double click", "camera as opened"},
    {"Ctrl+click", "type a slider's number"},
    {"right click", "back to the scene's value"},
    {"drop a file",
     "open a scene, a lesson, a model or a capture's .json; a .png or .jpg: the texture of the object shown"},
};

std::vector<HelpLine> help_lines() {
    using Group = Action::Group;
    std::vector<HelpLine> lines;
    for (const auto &[group, title] :
         {std::pair(Group::layout, "Views"), std::pair(Group::key_only, "Keys"), std::pair(Group::edit, "Edit"),
          std::pair(Group::lesson, "Lesson"), std::pair(Group::window, "Window and tabs")}) {
        lines.push_back({"", title});
        for (const Action &action : actions()) {
            if (action.group == group && !action.shown.empty()) {
                const char *colon = action.help.empty() ? "" : ": ";
                lines.push_back({action.shown, action.name + colon + action.help});
            }
        }
    }
    lines.insert(lines.end(), std::begin(keyboard_help), std::end(keyboard_help));
    lines.insert(lines.end(), std::begin(mouse_help), std::end(mouse_help));
    return lines;
}

constexpr float key_ems = 7.5F, column_ems = 34; // of the list, in text heights

void draw_help(const HelpLine &line) {
    if (line.shown.empty()) {
        heading(line.help);
        return;
    }
    ImGui::TextColored(side_color(false), "%s", line.shown.c_str());
    ImGui::SameLine(ImGui::GetFontSize() * key_ems);
    wrapped_text(ImGui::GetStyleColorVec4(ImGuiCol_Text), line.help);
}

/// In as many columns as the window is wide for, two at most.
void draw_help_columns(float width) {
    const std::vector<HelpLine> lines = help_lines();
    const bool two = width > 2 * column_ems * ImGui::GetFontSize();
    const float column = two ? (width - ImGui::GetFontSize()) / 2 : width;
    const std::size_t first = two ? (lines.size() + 1) / 2 : lines.size();
    if (!ImGui::BeginTable("keys", two ? 2 : 1, ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (int i = 0; i < (two ? 2 : 1); ++i) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, column);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2}); // else 1280x720 is too low
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i == first) {
            ImGui::TableNextColumn();
        }
        draw_help(lines[i]);
    }
    ImGui::PopStyleVar();
    ImGui::EndTable();
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
    const bool usable = found != actions().end() && (!found->is_usable || found->is_usable(session));
    if (usable && (!typing || while_typing)) {
        found->run(session);
    }
}

void key_list(Session &session) {
    if (!session.appearance.key_list) {
        return;
    }
    const ImGuiViewport &window = *ImGui::GetMainViewport();
    const ImGuiStyle &style = ImGui::GetStyle();
    const float em = ImGui::GetFontSize();
    const float beside = 2 * style.WindowPadding.x + style.ScrollbarSize + 2 * style.CellPadding.x;
    const float width = std::min(window.WorkSize.x - em - beside, 2 * (column_ems + 2) * em);
    ImGui::SetNextWindowSizeConstraints({width + beside, 0},
                                        {width + beside, window.WorkSize.y - ImGui::GetFrameHeight()});
    ImGui::SetNextWindowPos(window.GetWorkCenter(), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;
    if (ImGui::Begin("Keys and mouse", &session.appearance.key_list, flags)) {
        draw_help_columns(width);
        scroll_by_keys();
    }
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    describe_text(session, "Keys", low, {low.x + size.x, low.y + size.y},
                  ImGui::GetScrollMaxY() > 0 ? "scrolls" : "whole");
    ImGui::End();
}

} // namespace sandbox
