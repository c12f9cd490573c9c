#pragma once

#include "scene/assets.h"
#include "shading/technique.h"
#include "ui/capture_queue.h"
#include "ui/file_dialog.h"
#include "ui/gui.h"
#include "ui/host.h"
#include "ui/notice.h"
#include "ui/session/open_file.h"
#include "ui/session/own_files.h"
#include "ui/session/settings.h"
#include "ui/side_finder.h"
#include "ui/tabs/bottom_panel.h"
#include "ui/views/view_painter.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

namespace sandbox {

struct WindowOptions {
    OpenedFile file;      ///< shown first
    std::string lesson;   ///< then this one: a built-in name or a path; empty: none
    std::string exercise; ///< likewise
    /// If the file names no techniques:
    Technique left{.frequency = Frequency::per_vertex, .model = Model::blinn_phong}; ///< one cause of difference
    Technique right{.frequency = Frequency::per_pixel, .model = Model::blinn_phong};
    Assets assets{"assets"};
    Assets shaders{"shaders"};
    std::optional<Size> size;            ///< at first; none: as the settings say
    Settings settings;                   ///< as read
    std::filesystem::path settings_file; ///< empty: nothing is kept
    std::string message;                 ///< in the status line, first
    Profile profile = default_profile;   ///< of what the window stands on
    bool run_times = true;
    std::string language; ///< of languages; empty: as the settings say
};

/// All that happens inside a window, whatever the window stands on: made in this order, destroyed in reverse.
class Window {
  public:
    Window(const WindowOptions &options, Host &host);

    /// Takes the input that has arrived and, if it or anything else may change what is shown, draws a frame.
    void step();
    /// Is another frame needed though nothing arrives?
    [[nodiscard]] bool unsettled() const { return frames_left_ > 0; }
    /// Until the next step() is needed though nothing arrives, at least 0; infinite: none is.
    [[nodiscard]] double seconds_left() const;
    /// While a motion plays: goes on by a moment once it is due. A slow machine plays slower, and leaves out none.
    void keep_time();
    /// Goes on by a moment now, if a motion plays.
    void play_moment();
    /// Does work in the background go on, whose result will be shown?
    [[nodiscard]] bool busy() const;
    /// Keeps what the settings remember.
    ~Window();
    Window(const Window &) = delete;
    Window &operator=(const Window &) = delete;
    /// Writes the settings; what is shown, as a sidecar's text, empty before that.
    std::string keep();
    [[nodiscard]] bool quit_asked() const { return session_.requests.quit; }
    [[nodiscard]] Session &session() { return session_; }

  private:
    /// Is there a file that may be saved while nothing arrives?
    [[nodiscard]] bool watches_files() const;
    void take_input();
    void expire_messages(bool answered);
    void draw();
    void answer_requests();
    void take_dropped(const std::string &path);
    void open(const std::string &name_or_path);
    void open_lesson(const std::string &name_or_path, std::size_t step);
    void open_exercise(const std::string &name_or_path);
    void begin_exercise();
    void load(const Scene &scene, const std::string &message);
    void capture();
    void end_capture(const CaptureQueue::Outcome &outcome);
    void save(const std::string &path);
    void speak(const std::string &language);
    void take_opened(const OpenedFile &file);
    void show_view(const OpenedFile &file);
    void use_clipboard(const Requests &requests);
    void keep_settings();
    std::string state();
    void capture_window(Size size);
    void say_captured(const std::string &path);

    static constexpr int settling_frames = 3; ///< Dear ImGui answers an input over up to three frames

    Assets assets_;
    bool polls_shaders_;
    OwnFiles own_files_;
    Host &host_;
    DrawnBy drawn_by_;
    Gui gui_;
    ViewPainter painter_;
    Session session_;
    BackgroundRenderer background_;
    DrawingSupplies supplies_;
    BottomPanel bottom_;
    SideFinder finder_;
    Settings settings_;
    std::filesystem::path settings_file_;
    FileDialog dialog_;
    std::string shown_title_;
    Notice notice_;
    std::string timed_message_; ///< the status line's, and until when it stands
    double message_until_ = INFINITY;
    double next_moment_at_ = 0; ///< by the host's clock
    int frames_left_;
    bool exposed_ = true; ///< what was shown may be lost
    CaptureQueue captures_;
};

} // namespace sandbox
