#include "ui/widgets/theme.h"

#include <initializer_list>
#include <iterator>

namespace sandbox {

namespace {

ImVec4 rgb(unsigned hex, float alpha = 1) {
    const auto part = [hex](unsigned shift) { return static_cast<float>((hex >> shift) & 0xFFU) / 255.0F; };
    return {part(16), part(8), part(0), alpha};
}

/// In both, the contrast of text is above 12:1 and that of the borders of controls above 3:1.
struct Palette {
    ImVec4 text, quiet, error, window, popup, frame, frame_hovered, frame_active, border, accent, accent_hovered,
        header, header_hovered, on_accent, left, right;
};

Palette dark_palette() {
    return {rgb(0xF4F6F8), rgb(0xA9B4C0), rgb(0xFF8A75), rgb(0x14171B), rgb(0x1C2026), rgb(0x2B323B),
            rgb(0x38424E), rgb(0x45515F), rgb(0x66727F), rgb(0x2F74BD), rgb(0x4A90D9), rgb(0x252B33),
            rgb(0x313A45), rgb(0xFFFFFF), rgb(0xFFB454), rgb(0x6DB8FF)};
}

Palette light_palette() {
    return {rgb(0x101418), rgb(0x4A5663), rgb(0xB3200A), rgb(0xF7F8FA), rgb(0xFFFFFF), rgb(0xDCE1E7),
            rgb(0xCDD5DD), rgb(0xBCC6D1), rgb(0x7A8794), rgb(0x7DB3EA), rgb(0x9CC6F0), rgb(0xE3E8ED),
            rgb(0xD3DBE3), rgb(0x06121F), rgb(0xA34F00), rgb(0x0B5CAD)};
}

void apply_colors(const Palette &p) {
    ImVec4 *colors = ImGui::GetStyle().Colors;
    const auto set = [colors](std::initializer_list<ImGuiCol> which, ImVec4 color) {
        for (const ImGuiCol i : which) {
            colors[i] = color;
        }
    };
    set({ImGuiCol_Text}, p.text);
    set({ImGuiCol_TextDisabled}, p.quiet);
    set({ImGuiCol_WindowBg, ImGuiCol_ChildBg}, p.window);
    set({ImGuiCol_PopupBg, ImGuiCol_MenuBarBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive}, p.popup);
    set({ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Tab}, p.frame);
    set({ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_TabHovered}, p.frame_hovered);
    set({ImGuiCol_FrameBgActive, ImGuiCol_TabActive}, p.frame_active);
    set({ImGuiCol_ButtonActive, ImGuiCol_SliderGrab, ImGuiCol_PlotHistogram}, p.accent);
    set({ImGuiCol_CheckMark, ImGuiCol_NavHighlight}, p.right);
    set({ImGuiCol_SliderGrabActive}, p.accent_hovered);
    set({ImGuiCol_Header, ImGuiCol_TableHeaderBg}, p.header);
    set({ImGuiCol_TableRowBgAlt}, ImVec4(p.header.x, p.header.y, p.header.z, 0.5F));
    set({ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive}, p.header_hovered);
    set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong}, p.border);
    set({ImGuiCol_ScrollbarBg}, p.window);
    set({ImGuiCol_ScrollbarGrab}, p.frame_active);
    set({ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive}, p.border);
    set({ImGuiCol_TextSelectedBg}, ImVec4(p.accent.x, p.accent.y, p.accent.z, 0.4F));
}

/// The theme in use, recognised by its background.
bool is_dark() { return ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x < 0.5F; }
Palette palette() { return is_dark() ? dark_palette() : light_palette(); }

/// No two within 20 of CIELAB for normal, red-blind or green-blind eyes.
constexpr unsigned dark_series[] = {0x7D7570, 0xFF8A4A, 0x4477FF, 0xB8FFC8, 0xC6B8FF, 0xDDFF11};
constexpr unsigned light_series[] = {0x8A8A9C, 0xE8254F, 0x0072B2, 0x175A20, 0x7315D9, 0xFF8811};

} // namespace

bool is_upright(float width, float height, float text_height) { return width < 36 * text_height && height > width; }

void apply_theme(bool dark, float scale) {
    ImGuiStyle &style = ImGui::GetStyle();
    style = ImGuiStyle(); // sizes are scaled from their originals, never twice
    apply_colors(dark ? dark_palette() : light_palette());
    style.WindowPadding = {8, 6};
    style.FramePadding = {6, 3};
    style.ItemSpacing = {8, 4};
    style.ItemInnerSpacing = {5, 4};
    style.CellPadding = {4, 1};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 12;
    style.GrabMinSize = 10;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = style.TabRounding = 3;
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 1; // controls stand out on any projector
    style.ScaleAllSizes(scale);
}

ImVec4 quiet_text() { return palette().quiet; }
ImVec4 error_text() { return palette().error; }
ImVec4 text_on_accent() { return palette().on_accent; }
ImVec4 series_color(int style) {
    const auto i = static_cast<std::size_t>(style) % std::size(dark_series);
    return rgb(is_dark() ? dark_series[i] : light_series[i]);
}
ImVec4 front_color() { return rgb(is_dark() ? 0xB98D0A : 0xF2B705, 0.55F); }
ImVec4 side_color(bool right) { return right ? palette().right : palette().left; }

} // namespace sandbox
