#include "ui/window.h"

#include "capture/sidecar.h"
#include "image/error.h"
#include "image/image_file.h"
#include "image/system_font.h"
#include "render/context.h"
#include "scene/scene_file.h"
#include "teach/files/taught_file.h"
#include "teach/lesson.h"
#include "teach/marking/exercise.h"
#include "ui/desktop.h"
#include "ui/frame.h"
#include "ui/keys.h"
#include "ui/session/put_texture.h"
#include "ui/session/shown_characters.h"
#include "ui/session/taught.h"
#include "ui/session/written_files.h"
#include "ui/tabs/bottom_tabs.h"
#include "ui/views/painters.h"
#include "ui/widgets/theme.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace sandbox {

namespace {

constexpr double message_seconds = 8, error_seconds = 30; // in the status line

Document first_document(const WindowOptions &options) {
    const Document plain = document_of(options.file.name, options.file.scene, options.left, options.right);
    return document_from(options.file, Session(plain));
}

} // namespace

Window::Window(const WindowOptions &options, Host &host)
    : assets_(options.assets), polls_shaders_(!options.shaders.folder().empty()),
      host_(host), drawn_by_{host.context().renderer(), host.context().version()}, gui_(host),
      painter_(options.assets, options.shaders), session_(first_document(options)),
      background_(host.context(), options.assets, options.shaders), supplies_{&background_, drawn_by_},
      bottom_(supplies_), finder_(supplies_), settings_(options.settings), settings_file_(options.settings_file),
      frames_left_(settling_frames), captures_(supplies_, painter_.renderer()) {
    show_view(options.file);
    const Size size = host_.framebuffer_size();
    if (!options.file.capture &&
        is_upright(static_cast<float>(size.width), static_cast<float>(size.height), 16 * host_.content_scale())) {
        session_.view.layout = Layout::wipe; // two views would be too narrow
    }
    session_.appearance.run_times = options.run_times;
    session_.appearance.dark = settings_.dark;
    session_.appearance.panels = settings_.panels;
    session_.appearance.scale = static_cast<float>(settings_.scale);
    session_.appearance.sizes = settings_.panel_sizes;
    session_.scenes = builtin_scenes(assets_);
    session_.textures = assets_.list("textures/");
    for (std::string &texture : session_.textures) {
        texture.erase(0, std::string("textures/").size());
    }
    session_.progress = settings_.lessons;
    session_.solved = settings_.exercises;
    attempt(session_, "", [&] { load(options.file.scene, options.message); });
    attempt(session_, "", [&] {
        speak(!options.language.empty()            ? options.language
              : !options.settings.language.empty() ? options.settings.language
                                                   : system_language());
    });
    if (!options.lesson.empty()) {
        open_lesson(options.lesson, 0);
    }
    if (!options.exercise.empty()) {
        open_exercise(options.exercise);
    }
}

void Window::play_moment() {
    next_moment(session_);
    frames_left_ = std::max(frames_left_, session_.playback.playing ? 1 : settling_frames);
}

void Window::keep_time() {
    const double now = host_.seconds();
    if (session_.playback.playing && now >= next_moment_at_) {
        play_moment();
        next_moment_at_ = std::max(next_moment_at_, now - 1.0 / moments_a_second) + 1.0 / moments_a_second;
    }
}

void Window::step() {
    take_input();
    if (frames_left_ > 0) {
        draw();
        answer_requests();
    }
}

bool Window::watches_files() const {
    return polls_shaders_ || session_.document.left.own || session_.document.right.own;
}

bool Window::busy() const {
    return captures_.busy() || bottom_.busy() || finder_.busy() || painter_.awaited() != nullptr;
}

void Window::take_input() {
    const Arrivals arrivals = host_.take_arrivals();
    const bool reloaded = polls_shaders_ && painter_.reload_changed_shaders();
    const bool own_saved = own_files_.read_saved(session_);
    exposed_ |= arrivals.exposed;
    use_characters(session_, arrivals.typed);
    frames_left_ = arrivals.any || reloaded || own_saved ? settling_frames : frames_left_;
    const News news = std::max(bottom_.take_news(session_), finder_.take_news());
    const int frames = news == News::none       ? 0
                       : news == News::progress ? 1
                                                : settling_frames; // few beside a measurement
    frames_left_ = std::max(frames_left_, frames);
    if (const auto outcome = captures_.take_outcome()) {
        end_capture(*outcome);
    }
    const bool typing = ImGui::GetIO().WantTextInput;
    if (!ImGui::IsAnyItemActive() || typing) {
        for (const KeyPress &press : arrivals.keys) {
            press_key(session_, press.key, press.mods, press.repeated, typing);
        }
    }
    if (arrivals.question_mark && !typing) {
        session_.appearance.key_list = !session_.appearance.key_list;
    }
    if (!arrivals.dropped.empty()) {
        take_dropped(arrivals.dropped.front());
    }
    const bool answered = !arrivals.keys.empty() || !arrivals.dropped.empty() || ImGui::IsAnyMouseDown();
    expire_messages(answered);
    session_.view.show_right = host_.space_held() && !typing && !ImGui::GetIO().NavVisible; // else Space presses
}

void Window::expire_messages(bool answered) {
    const double now = host_.seconds();
    if (notice_.shown() && (answered || notice_.seconds_left(now) <= 0)) {
        notice_.clear();
        frames_left_ = settling_frames;
    }
    const Message &message = session_.message;
    if (message.text != timed_message_) {
        timed_message_ = message.text;
        message_until_ = message.text.empty() ? INFINITY : now + (message.error ? error_seconds : message_seconds);
    } else if (now >= message_until_) {
        session_.message = {};
        frames_left_ = settling_frames;
    }
}

double Window::seconds_left() const {
    constexpr double poll_seconds = 0.5; // of files
    if (unsettled()) {
        return 0;
    }
    const double now = host_.seconds();
    const double moment = session_.playback.playing ? std::max(next_moment_at_ - now, 0.0) : INFINITY;
    const double poll = watches_files() ? poll_seconds : INFINITY;
    return std::max(std::min({notice_.seconds_left(now), message_until_ - now, moment, poll}), 0.0);
}

void Window::draw() {
    --frames_left_;
    const Size size = host_.framebuffer_size();
    if (size.width == 0 || size.height == 0) {
        return; // minimised
    }
    const std::string title = session_.document.opened->name + " - Shading Sandbox";
    if (title != shown_title_) {
        host_.set_title(title);
        shown_title_ = title;
    }
    host_.set_full_screen(session_.appearance.full_screen);
    session_.widgets.begin_frame();
    use_shown_characters(session_, settings_.recent, dialog_.path());
    gui_.begin_frame(session_.appearance, session_.document.step != nullptr, session_.rare_characters);
    finder_.update(session_, painter_);
    draw_frame(session_, painter_, bottom_);
    dialog_.draw(session_, settings_.recent);
    notice_.draw();
    const bool read = std::exchange(session_.requests.capture_window, false);
    if (gui_.end_frame(painter_.changes()) || exposed_ || read) { // else what is shown stays
        exposed_ = false;
        const ImVec4 background = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
        begin_window_surface(host_.framebuffer(), size, {background.x, background.y, background.z});
        Gui::draw();
        if (read) {
            capture_window(size); // before the frame is given away
        }
        host_.present();
    }
}

void Window::answer_requests() {
    const Requests requests = std::exchange(session_.requests, {});
    session_.requests.quit = requests.quit;
    if (requests.open) {
        open(*requests.open);
    }
    if (requests.open_lesson) {
        open_lesson(*requests.open_lesson, requests.open_step);
    }
    if (requests.open_exercise) {
        open_exercise(*requests.open_exercise);
    }
    if (requests.begin_exercise) {
        begin_exercise();
    }
    if (requests.save) {
        save(*requests.save);
    }
    if (requests.language) {
        settings_.language = *requests.language;
        attempt(session_, "", [&] { speak(*requests.language); });
    }
    if (requests.ask_open && !host_.pick_file()) {
        dialog_.show(FileDialog::Purpose::open, "");
    }
    if (requests.ask_save) {
        attempt(session_, "", [&] {
            const auto path = capture_folder() / (session_.document.opened->name + ".json");
            dialog_.show(FileDialog::Purpose::save, path.string());
        });
    }
    if (requests.copy_scene || requests.paste_scene) {
        use_clipboard(requests);
    }
    if (requests.copy_link) {
        host_.share(state());
        session_.message = {session_.text("message.copied_link"), false};
    }
    if (requests.show_licences) {
        host_.show_licences();
    }
    if (requests.capture) {
        capture();
    }
    if (requests.open_folder) {
        attempt(session_, "", [&] { open_on_desktop(capture_folder()); });
    }
    Requests nothing;
    nothing.quit = requests.quit;
    if (requests != nothing) {
        frames_left_ = settling_frames;
    }
}

void Window::take_dropped(const std::string &path) {
    if (is_image_name(path)) {
        attempt(session_, session_.text("message.no_texture"),
                [&] { put_texture(session_, path, painter_.renderer().resources()); });
    } else {
        session_.requests.open = path;
    }
}

/// In its tab. A bad one changes nothing.
void Window::open_lesson(const std::string &name_or_path, std::size_t step) {
    attempt(session_, "", [&] {
        const bool file = taught_file(name_or_path) == TaughtFile::lesson;
        const std::string id = file ? std::filesystem::absolute(name_or_path).string() : name_or_path;
        const auto lesson = read_lesson(session_, assets_, id);
        load(lesson->steps[std::min(step, lesson->steps.size() - 1)].scene, "");
        const bool goes_on = session_.document.step != nullptr && !session_.appearance.panels; // from bug to bug
        show_step(session_, lesson, id, step);
        if (!goes_on) {
            session_.message = {session_.text("lesson_tab.opened", lesson->title.text), false};
            session_.appearance.tab = tab_made_by(lesson_tab);
            session_.appearance.panels = true;
        }
        if (file) {
            add_recent(settings_, id);
        }
    });
}

/// In its tab, likewise.
void Window::open_exercise(const std::string &name_or_path) {
    attempt(session_, "", [&] {
        const bool file = taught_file(name_or_path) == TaughtFile::exercise;
        const std::string id = file ? std::filesystem::absolute(name_or_path).string() : name_or_path;
        const auto exercise = read_exercise(session_, assets_, id);
        load(exercise->shown_scene(), session_.text("exercise_tab.opened", exercise->title.text));
        show_exercise(session_, exercise, id, painter_.renderer().parts());
        session_.appearance.tab = tab_made_by(exercise_tab);
        session_.appearance.panels = true;
        if (file) {
            add_recent(settings_, id);
        }
    });
}

/// Whoever has no editor for it finds its path in the status line.
void Window::begin_exercise() {
    attempt(session_, "", [&] {
        const auto shown = session_.document.exercise;
        if (shown == nullptr) {
            return;
        }
        write_student_file(*shown, painter_.renderer().parts());
        session_.message = {session_.text("exercise_tab.written", shown->file), false};
        ImGui::SetClipboardText(shown->file.c_str());
        open_on_desktop(shown->file);
    });
}

void Window::open(const std::string &name_or_path) {
    attempt(session_, "", [&] {
        switch (taught_file(name_or_path)) {
        case TaughtFile::lesson:
            return open_lesson(name_or_path, 0);
        case TaughtFile::exercise:
            return open_exercise(name_or_path);
        case TaughtFile::none:
            break;
        }
        if (is_own_name(name_or_path)) {
            open_own(session_, name_or_path);
            session_.message = {session_.text("message.own_opened", name_or_path), false};
            return add_recent(settings_, std::filesystem::absolute(name_or_path).string());
        }
        const OpenedFile file = open_file(name_or_path, assets_);
        take_opened(file);
        if (std::filesystem::is_regular_file(name_or_path)) {
            add_recent(settings_, name_or_path);
        }
    });
}

/// English, with a hint, where no font has the language's characters.
void Window::speak(const std::string &language) {
    const Words words = words_in(language, assets_);
    std::set<char32_t> before = session_.rare_characters;
    for (const auto &[key, text] : words.all()) {
        use_characters(session_, text);
    }
    if (session_.rare_characters != before && !chinese_font()) {
        session_.rare_characters = std::move(before);
        session_.words = words.english();
        list_taught(session_, assets_);
        throw InputError("{}", words.english().text("message.no_font"));
    }
    session_.words = words;
    list_taught(session_, assets_);
}

/// Throws InputError, and then nothing changes.
void Window::take_opened(const OpenedFile &file) {
    load(file.scene, session_.text("message.opened", file.name));
    show_document(session_, document_from(file, session_));
    show_view(file);
}

void Window::show_view(const OpenedFile &file) {
    take_view(session_.view, file);
    if (const auto tab = tab_of(session_.view.overlay); tab && file.marks) {
        session_.appearance.tab = tab;
    }
}

void Window::use_clipboard(const Requests &requests) {
    attempt(session_, "", [&] {
        if (requests.copy_scene) {
            ImGui::SetClipboardText(scene_text(session_.document.scene).c_str());
            session_.message = {session_.text("message.copied_scene"), false};
        } else if (requests.paste_scene) {
            const char *text = ImGui::GetClipboardText();
            take_opened(open_text(text != nullptr ? text : ""));
        }
    });
}

Window::~Window() { keep_settings(); }

/// Shows `message` or, if a mesh is odd, what is odd about it. Throws InputError for textures and models that cannot be
/// read.
void Window::load(const Scene &scene, const std::string &message) {
    std::string note;
    const auto resources = painter_.renderer().resources().load(scene);
    for (std::size_t i = 0; i < resources.size() && note.empty(); ++i) {
        const Mesh &mesh = *resources[i].mesh;
        note = mesh.against_normals == 0
                   ? ""
                   : session_.text("message.clockwise", file_text(session_.words, scene.objects[i].name),
                                   mesh.against_normals, mesh.triangles.size());
    }
    session_.message = {note.empty() ? message : note, false};
}

} // namespace sandbox
