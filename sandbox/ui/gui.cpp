#include "ui/gui.h"

#include "image/system_font.h"
#include "render/gl_state.h"
#include "ui/gui_keys.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace sandbox {

namespace {

template <typename T> void append_bytes(std::string &bytes, const T *values, int count) {
    bytes.append(reinterpret_cast<const char *>(values), sizeof(T) * static_cast<std::size_t>(count));
}

} // namespace

Gui::Gui(Host &host) : host_(host) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.ConfigInputTextCursorBlink = false; // a blinking cursor would need frames while nothing happens
    host_.begin_gui();
    ImGui_ImplOpenGL3_Init(is_es() ? "#version 300 es" : "#version 330 core");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    host_.end_gui();
    ImGui::DestroyContext();
}

void Gui::restyle(bool dark, float scale, const std::set<char32_t> &rare) {
    if (scale != scale_ || rare.size() != characters_) {
        load_fonts(scale, rare);
        if (scale_ != 0) { // the first texture is made by the backend itself
            ImGui_ImplOpenGL3_DestroyFontsTexture();
            ImGui_ImplOpenGL3_CreateFontsTexture();
            shown_.clear();
        }
    }
    apply_theme(dark, scale);
    scale_ = scale;
    characters_ = rare.size();
    dark_ = dark;
}

void Gui::begin_frame(const Appearance &appearance, bool lesson, const std::set<char32_t> &rare) {
    const float scale = appearance.scale * host_.content_scale();
    if (scale != scale_ || appearance.dark != dark_ || rare.size() != characters_) {
        restyle(appearance.dark, scale, rare);
    }
    ImGui_ImplOpenGL3_NewFrame();
    host_.feed_gui();
    const ImGuiIO &io = ImGui::GetIO();
    KeysDown down = host_.take_keys();
    if ((down.mods & GLFW_MOD_CONTROL) == 0) { // Ctrl+Tab goes to the next panel, Tab hides them all
        down.keys.erase(GLFW_KEY_TAB);
    }
    if (lesson && !io.WantTextInput && !appearance.key_list) { // they go through its steps
        for (const int key : {GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN, GLFW_KEY_HOME, GLFW_KEY_END}) {
            down.keys.erase(key);
        }
    }
    press_gui_keys(down);
    ImGui::NewFrame();
}

bool Gui::end_frame(unsigned long pictures) {
    ImGui::Render();
    const ImDrawData &data = *ImGui::GetDrawData();
    pending_.clear();
    append_bytes(pending_, &pictures, 1);
    append_bytes(pending_, &data.DisplaySize, 1);
    append_bytes(pending_, &data.FramebufferScale, 1);
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList &list = *data.CmdLists[i];
        append_bytes(pending_, list.VtxBuffer.Data, list.VtxBuffer.Size);
        append_bytes(pending_, list.IdxBuffer.Data, list.IdxBuffer.Size);
        for (const ImDrawCmd &command : list.CmdBuffer) {
            append_bytes(pending_, &command.ClipRect, 1);
            append_bytes(pending_, &command.TextureId, 1);
            append_bytes(pending_, &command.ElemCount, 1);
            append_bytes(pending_, &command.UserCallbackData, 1);
        }
    }
    if (pending_ == shown_) {
        return false;
    }
    shown_.swap(pending_);
    return true;
}

void Gui::draw() {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (is_es()) {
        forget_gl_errors(); // the backend, as Debian builds it, asks for a polygon mode, which ES does not have
    }
}

} // namespace sandbox
