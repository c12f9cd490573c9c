#include "ui/file_dialog.h"

#include "ui/desktop.h"
#include "ui/jobs/background_job.h"
#include "ui/jobs/drawing_job.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

namespace sandbox {

namespace {

/// What a program prints, without the line's end; empty if it fails.
std::string output_of(const std::string &command) {
    std::FILE *pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) {
        return {};
    }
    std::string text;
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
        text += buffer.data();
    }
    const bool well = pclose(pipe) == 0;
    text.erase(text.find_last_not_of('\n') + 1);
    return well ? text : "";
}

} // namespace

FileDialog::FileDialog() {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
        return;
    }
    command_ = is_installed("zenity") ? "zenity --file-selection" : is_installed("kdialog") ? "kdialog" : "";
}

FileDialog::~FileDialog() = default;

void FileDialog::show(Purpose purpose, std::string path) {
    purpose_ = purpose;
    path_ = std::move(path);
    asked_ = true;
}

void FileDialog::settle(Session &session, const std::string &path) {
    (purpose_ == Purpose::save ? session.requests.save : session.requests.open) = path;
    ImGui::CloseCurrentPopup();
}

void FileDialog::browse() {
    const bool save = purpose_ == Purpose::save;
    const std::string command = command_ == "kdialog"
                                    ? std::string("kdialog ") + (save ? "--getsavefilename ." : "--getopenfilename .")
                                    : command_ + (save ? " --save" : "");
    browsed_ = std::make_shared<std::string>();
    job_ = std::make_unique<BackgroundJob>(
        [command, browsed = browsed_](JobReporter &) { *browsed = output_of(command + " 2>/dev/null"); }, wake_window);
}

void FileDialog::take_browsed(Session &session) {
    if (job_ && job_->state() != JobState::running) {
        job_.reset();
        if (!browsed_->empty()) {
            settle(session, *browsed_);
        }
    }
}

void FileDialog::draw_fields(Session &session, const std::vector<std::string> &recent) {
    const ScopedName scope(session, "File");
    if (std::exchange(asked_, false)) {
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const bool entered =
        ImGui::InputText("##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    describe_item(session, "path", session.text("file.path.help"), path_);
    if (purpose_ == Purpose::open) {
        for (const std::string &file : recent) {
            if (ImGui::Selectable(file.c_str())) {
                settle(session, file);
            }
            describe_item(session, file, "");
        }
    }
    const bool done = button(session, session.label(purpose_ == Purpose::save ? "file.save" : "file.open"), "");
    ImGui::SameLine();
    const bool cancelled = button(session, session.label("cancel"), "") || is_key_pressed(ImGuiKey_Escape);
    if (!command_.empty()) {
        ImGui::SameLine();
        ImGui::BeginDisabled(job_ != nullptr);
        if (button(session, session.label("file.browse"), session.text("file.browse.help"))) {
            browse();
        }
        ImGui::EndDisabled();
        take_browsed(session);
    }
    if ((entered || done) && !path_.empty()) {
        settle(session, path_);
    } else if (cancelled) {
        ImGui::CloseCurrentPopup();
    }
}

void FileDialog::draw(Session &session, const std::vector<std::string> &recent) {
    const std::string title =
        session.text(purpose_ == Purpose::save ? "file.save.title" : "file.open.title") + "###file";
    if (asked_) {
        ImGui::OpenPopup("###file");
    }
    ImGui::SetNextWindowSize({std::min(ImGui::GetFontSize() * 40, ImGui::GetMainViewport()->WorkSize.x * 0.9F), 0});
    if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove)) {
        return;
    }
    draw_fields(session, recent);
    ImGui::EndPopup();
}

} // namespace sandbox
