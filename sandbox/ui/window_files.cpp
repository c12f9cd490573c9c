#include "capture/sidecar.h"
#include "image/image_file.h"
#include "render/context.h"
#include "scene/scene_file.h"
#include "ui/session/written_files.h"
#include "ui/window.h"

#include <imgui.h>

/// What a window writes: scenes, captures, settings.
namespace sandbox {

void Window::save(const std::string &path) {
    attempt(session_, session_.text("message.not_saved"), [&] {
        std::filesystem::path file = std::filesystem::absolute(path);
        if (!file.has_extension()) {
            file += ".json";
        }
        write_file(file, scene_text(session_.document.scene, file.parent_path()));
        add_recent(settings_, file);
        session_.message = {session_.text("message.saved", file.string()), false};
    });
}

void Window::keep_settings() {
    if (settings_file_.empty()) {
        return;
    }
    settings_.dark = session_.appearance.dark;
    settings_.panels = session_.appearance.panels;
    settings_.scale = static_cast<double>(session_.appearance.scale);
    settings_.panel_sizes = session_.appearance.sizes;
    settings_.lessons = session_.progress;
    settings_.exercises = session_.solved;
    const Size size = host_.framebuffer_size();
    if (!session_.appearance.full_screen && size.width >= least_window.width && size.height >= least_window.height) {
        const auto scale = static_cast<double>(host_.content_scale());
        settings_.window = {static_cast<int>(size.width / scale), static_cast<int>(size.height / scale)};
    }
    attempt(session_, session_.text("message.settings_not_kept"), [&] { write_settings(settings_file_, settings_); });
}

/// What a capture would have beside it; empty before anything is shown.
std::string Window::state() {
    const Size each = painter_.view(false).size;
    if (each.width == 0 || each.height == 0) {
        return {}; // nothing has been shown yet
    }
    return sidecar_text(scene_in_view(shown_document(session_), each), picture_options(session_, each), drawn_by_);
}

std::string Window::keep() {
    keep_settings();
    return state();
}

void Window::capture() {
    attempt(session_, session_.text("message.not_captured"), [&] {
        const Size each = painter_.view(false).size;
        captures_.add({session_.document.opened->name, scene_in_view(shown_document(session_), each),
                       picture_options(session_, each)});
        if (captures_.waiting() > 0) {
            session_.message = {session_.text("message.waiting", captures_.waiting()), false};
        }
    });
}

void Window::end_capture(const CaptureQueue::Outcome &outcome) {
    if (outcome.failure.empty()) {
        say_captured(outcome.path);
    } else {
        session_.message = {session_.text("message.not_captured") + outcome.failure, true};
    }
    frames_left_ = settling_frames;
}

/// The frame that has just been drawn.
void Window::capture_window(Size size) {
    attempt(session_, session_.text("message.not_captured"), [&] {
        const auto path =
            std::filesystem::absolute(free_name(capture_folder(), session_.document.opened->name + "-window"));
        write_file(path, encode_png(read_window_surface(host_.framebuffer(), size)));
        say_captured(path.string());
    });
    frames_left_ = settling_frames;
}

void Window::say_captured(const std::string &path) {
    session_.message = {session_.text("message.captured", path), false};
    ImGui::SetClipboardText(path.c_str());
    const std::string file = std::filesystem::path(path).filename().string();
    notice_.say(session_.text(session_.appearance.panels ? "notice.captured" : "notice.captured_bare", file),
                host_.seconds());
}

} // namespace sandbox
