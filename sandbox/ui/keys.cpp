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
/// Below the actions: groups of lines, each a text and its help.
constexpr std::string_view panel_lines[] = {"ctrl_tab", "arrows", "space", "enter", "edge"};
constexpr std::string_view mouse_lines[] = {"drag",         "drag_light", "right_drag",  "wheel",
                                            "double_click", "ctrl_click", "right_click", "drop"};

void add_lines(std::vector<HelpLine> &lines, const Session &session, std::string_view group,
               std::span<const std::string_view> words) {
    lines.push_back({"", session.text(fmt::format("keys.{}", group))});
    for (const std::string_view word : words) {
        const std::string key = fmt::format("keys.{}.{}", group, word);
        lines.push_back({session.text(key), session.text(key + ".help")});
    }
}

std::vector<HelpLine> help_lines(const Session &session) {
    using Group = Action::Group;
    std::vector<HelpLine> lines;
    for (const auto &[group, title] : {std::pair(Group::layout, "keys.views"), std::pair(Group::key_only, "keys.keys"),
                                       std::pair(Group::edit, "menu.edit"), std::pair(Group::lesson, "menu.lesson"),
                                       std::pair(Group::window, "keys.window")}) {
        lines.push_back({"", session.text(title)});
        for (const Action &action : actions()) {
            if (action.group == group && !action.shown.empty()) {
                const std::string name = label_of(session, action).shown, help = help_of(session, action);
                lines.push_back({action.shown, help.empty() ? name : session.text("keys.line", name, help)});
            }
        }
    }
    add_lines(lines, session, "panels", panel_lines);
    add_lines(lines, session, "mouse", mouse_lines);
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
void draw_help_columns(const Session &session, float width) {
    const std::vector<HelpLine> lines = help_lines(session);
    const bool two = width > 2 * column_ems * ImGui::GetFontSize();
    const float column = two ? (width - ImGui::GetFontSize()) / 2 : width;
    const std::size_t first = two ? (lines.size() + 1) / 2 : lines.size();
    if (!ImGui::BeginTable("keys", two ? 2 : 1, ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (int i = 0; i < (two ? 2 : 1); ++i) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, column);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1}); // else 1280x720 is too low
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
    if (ImGui::Begin(session.label("keys.title").id().c_str(), &session.appearance.key_list, flags)) {
        draw_help_columns(session, width);
        scroll_by_keys();
    }
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    describe_text(session, "Keys", low, {low.x + size.x, low.y + size.y},
                  ImGui::GetScrollMaxY() > 0 ? "scrolls" : "whole");
    ImGui::End();
}

} // namespace sandbox
