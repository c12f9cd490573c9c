#include "ui/window.h"

#include "capture/sidecar.h"
#include "image/image_file.h"
#include "measure/stability/textbook.h"
#include "render/context.h"
#include "render/glfw_context.h"
#include "scene/scene_file.h"
#include "ui/frame.h"
#include "ui/glfw_window.h"
#include "ui/gui.h"
#include "ui/keys.h"
#include "ui/mask_overlay.h"
#include "ui/session/open_file.h"
#include "ui/session/written_files.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <memory>

namespace sandbox {

namespace {

constexpr Size first_size{1280, 720};
constexpr int settling_frames = 3; // Dear ImGui answers an input over up to three frames
constexpr double shader_poll_seconds = 0.5;

Document first_document(const WindowOptions &options) {
    const Document plain = document_of(options.file.name, options.file.scene, options.left, options.right);
    return document_from(options.file, Session(plain));
}

/// Writes what the views show, and its sidecar beside it; returns the picture's path. Throws InputError.
std::filesystem::path capture_views(const Session &session, ViewPainter &painter, const DrawnBy &by) {
    const Size each = painter.view(false).size;
    const Scene scene = scene_in_view(session.document, each); // so that the sidecar alone gives the same picture
    const PictureOptions options = picture_options(session, each);
    Renderer &renderer = painter.renderer();
    const DrawView draw = [&](const Scene &s, const Technique &t, Size size) {
        return renderer.render(s, t, size).color;
    };
    const DrawView textbook = [&](const Scene &s, const Technique &t, Size size) {
        return textbook_picture(s, renderer.resources().load(s), t, size).color;
    };
    const Image linear = draw_picture(scene, options, draw, textbook);
    auto path = std::filesystem::absolute(free_name(capture_folder(), session.document.opened->name));
    write_file(path, encode_png(show_picture(linear, options)));
    write_file(sidecar_path(path), sidecar_text(scene, options, by));
    return path;
}

/// The parts of a running window: made in this order, destroyed in reverse.
class Window {
  public:
    explicit Window(const WindowOptions &options);
    void run();

  private:
    void wait();
    void take_input();
    void draw();
    void answer_requests();
    void open(const std::string &name_or_path);
    void load(const Scene &scene, const std::string &message);
    void capture();

    Assets assets_;
    bool polls_shaders_;
    GlfwWindow window_;
    std::unique_ptr<Context> context_;
    Gui gui_;
    ViewPainter painter_;
    Session session_;
    BottomPanel bottom_;
    MaskOverlay masks_;
    std::string shown_title_;
    int frames_left_ = settling_frames;
};

Window::Window(const WindowOptions &options)
    : assets_(options.assets), polls_shaders_(!options.shaders.folder().empty()), window_(first_size),
      context_(make_window_context(window_.handle())), gui_(window_.handle(), window_.content_scale()),
      painter_(options.assets, options.shaders), session_(first_document(options)),
      bottom_({options.assets, options.shaders, {context_->renderer(), context_->version()}}) {
    take_view(session_.view, options.file);
    session_.scenes = builtin_scenes(assets_);
    session_.textures = assets_.list("textures/");
    for (std::string &texture : session_.textures) {
        texture.erase(0, std::string("textures/").size());
    }
    attempt(session_, "", [&] { load(options.file.scene, "Drag to orbit, wheel to come closer.  ? lists the keys."); });
}

void Window::run() {
    draw();
    window_.show();
    while (!window_.close_asked() && !session_.requests.quit) {
        wait();
        take_input();
        if (frames_left_ > 0) {
            draw();
            answer_requests();
        }
    }
    window_.hide(); // work in the background may take a moment to stop
}

/// No event, no frame.
void Window::wait() {
    if (frames_left_ > 0) {
        glfwPollEvents();
    } else if (polls_shaders_) {
        glfwWaitEventsTimeout(shader_poll_seconds);
    } else {
        glfwWaitEvents();
    }
}

void Window::take_input() {
    const Arrivals arrivals = window_.take_arrivals();
    const bool reloaded = polls_shaders_ && painter_.reload_changed_shaders();
    frames_left_ = arrivals.any || reloaded ? settling_frames : frames_left_;
    const News news = std::max(bottom_.take_news(session_), masks_.take_news());
    const int frames = news == News::none       ? 0
                       : news == News::progress ? 1
                                                : settling_frames; // few beside a measurement
    frames_left_ = std::max(frames_left_, frames);
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
        session_.requests.open = arrivals.dropped.front();
    }
    session_.view.show_right = window_.space_held() && !typing && !ImGui::GetIO().NavVisible; // else Space presses
}

void Window::draw() {
    --frames_left_;
    const Size size = window_.framebuffer_size();
    if (size.width == 0 || size.height == 0) {
        return; // minimised
    }
    const std::string title = session_.document.opened->name + " - Shading Sandbox";
    if (title != shown_title_) {
        window_.set_title(title);
        shown_title_ = title;
    }
    window_.set_full_screen(session_.appearance.full_screen);
    gui_.begin_frame(session_.appearance);
    masks_.update(session_, painter_);
    draw_frame(session_, painter_, bottom_);
    begin_window_surface(size);
    gui_.end_frame();
    glfwSwapBuffers(window_.handle());
}

void Window::answer_requests() {
    const Requests requests = std::exchange(session_.requests, {});
    session_.requests.quit = requests.quit;
    if (requests.open) {
        open(*requests.open);
    }
    if (requests.capture) {
        capture();
    }
    if (requests.open || requests.capture) {
        frames_left_ = settling_frames;
    }
}

void Window::open(const std::string &name_or_path) {
    attempt(session_, "", [&] {
        const OpenedFile file = open_file(name_or_path, assets_);
        load(file.scene, "Opened " + file.name + ".");
        show_document(session_, document_from(file, session_));
        take_view(session_.view, file);
    });
}

/// Shows `message` or, if a mesh is odd, what is odd about it. Throws InputError for textures and models that cannot be
/// read.
void Window::load(const Scene &scene, const std::string &message) {
    std::string note;
    const auto resources = painter_.renderer().resources().load(scene);
    for (std::size_t i = 0; i < resources.size() && note.empty(); ++i) {
        note = winding_note(*resources[i].mesh);
        note = note.empty() ? "" : fmt::format("{}: {}.", scene.objects[i].name, note);
    }
    session_.message = {note.empty() ? message : note, false};
}

void Window::capture() {
    attempt(session_, "Not captured: ", [&] {
        const DrawnBy by{context_->renderer(), context_->version()};
        session_.message = {"Captured to " + capture_views(session_, painter_, by).string(), false};
    });
}

} // namespace

int run_window(const WindowOptions &options) {
    Window(options).run();
    return 0;
}

} // namespace sandbox
