#include "ui/gui.h"

#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace sandbox {

Gui::Gui(Host &host) : host_(host) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.ConfigInputTextCursorBlink = false; // a blinking cursor would need frames while nothing happens
    host_.begin_gui();
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    host_.end_gui();
    ImGui::DestroyContext();
}

void Gui::restyle(bool dark, float scale) {
    if (scale != scale_) {
        load_fonts(scale);
        if (scale_ != 0) { // the first texture is made by the backend itself
            ImGui_ImplOpenGL3_DestroyFontsTexture();
            ImGui_ImplOpenGL3_CreateFontsTexture();
        }
    }
    apply_theme(dark, scale);
    scale_ = scale;
    dark_ = dark;
}

void Gui::begin_frame(const Appearance &appearance) {
    const float scale = appearance.scale * host_.content_scale();
    if (scale != scale_ || appearance.dark != dark_) {
        restyle(appearance.dark, scale);
    }
    ImGui_ImplOpenGL3_NewFrame();
    host_.feed_gui();
    ImGuiIO &io = ImGui::GetIO();
    io.KeyMap[ImGuiKey_Tab] = io.KeyCtrl ? GLFW_KEY_TAB : -1; // Ctrl+Tab goes to the next panel, Tab hides them all
    ImGui::NewFrame();
}

void Gui::end_frame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

} // namespace sandbox
