#include "commands/commands.h"

#include "commands/own_flags.h"
#include "commands/session.h"
#include "image/image_file.h"

#include <charconv>
#include <chrono>
#include <fmt/format.h>
#include <iostream>
#include <nlohmann/json.hpp>
#include <variant>

namespace sandbox {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int most_frames = 1000000;

/// What frames are drawn into.
enum class Pixels { light, display };

Pixels parse_pixels(std::string_view text) {
    if (text == "float" || text == "display") {
        return text == "float" ? Pixels::light : Pixels::display;
    }
    throw InputError("expected float or display, got '{}'", text);
}

struct TimeFlags {
    std::string scene, technique{to_string(Technique{})};
    OwnFlags own;
    Size size = default_picture_size;
    Pixels pixels = Pixels::light;
    std::string frames = "30";
    std::filesystem::path out;
};

/// A number of frames; `where` names the flag or the line it came from.
int parse_frames(std::string_view text, std::string_view where) {
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) {
        text.remove_suffix(1);
    }
    int frames = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), frames);
    if (error != std::errc() || end != text.data() + text.size() || frames < 1 || frames > most_frames) {
        throw InputError("{}: expected a number of frames from 1 to {}, got '{}'", where, most_frames, text);
    }
    return frames;
}

/// One scene under one technique, drawn again and again into the same target.
class TimedFrames {
  public:
    TimedFrames(Renderer &renderer, const Scene &scene, const Technique &technique, Size size, Pixels pixels)
        : renderer_(renderer), scene_(scene), technique_(technique),
          target_(pixels == Pixels::light ? AnyTarget(std::in_place_type<Target>, size)
                                          : AnyTarget(std::in_place_type<ScreenTarget>, size)) {}

    /// Clear, draw, finish; the wall clock in milliseconds.
    double draw() {
        const Clock::time_point start = Clock::now();
        if (Target *light = std::get_if<Target>(&target_)) {
            renderer_.draw(scene_, technique_, *light);
        } else {
            renderer_.draw_shown(scene_, technique_, {}, std::get<ScreenTarget>(target_));
        }
        std::visit([](const auto &target) { target.finish(); }, target_);
        return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
    void print_batch(int frames) {
        std::vector<double> milliseconds(static_cast<std::size_t>(frames));
        for (double &ms : milliseconds) {
            ms = draw();
        }
        print(nlohmann::json{{"ms", milliseconds}}.dump() + "\n");
    }
    /// As a screen shows it.
    [[nodiscard]] ByteImage picture() const {
        if (const Target *light = std::get_if<Target>(&target_)) {
            return to_display(light->read_color());
        }
        const auto &screen = std::get<ScreenTarget>(target_);
        return read_window_surface(screen.framebuffer(), screen.size());
    }

  private:
    using AnyTarget = std::variant<Target, ScreenTarget>;
    Renderer &renderer_;
    const Scene &scene_;
    Technique technique_;
    AnyTarget target_;
};

int run_time(const TimeFlags &flags, const CommonOptions &common) {
    if (!flags.out.empty()) {
        check_output(flags.out, {".png"});
    }
    const bool by_lines = flags.frames == "-";
    const int frames = by_lines ? 0 : parse_frames(flags.frames, "--frames");
    OwnTechniques techniques(flags.own);
    const Technique technique = techniques.single("--technique", flags.technique);
    techniques.require_all_used();
    const Scene scene = open_scene(common, flags.scene, {}, flags.size);

    DrawingSession session(common, DrawingSession::Own::drawn_here);
    TimedFrames timed(session.renderer(), scene, technique, flags.size, flags.pixels);
    timed.draw();
    const auto first = Clock::now().time_since_epoch();
    const nlohmann::ordered_json header{
        {"case", fmt::format("{} {} {}x{}{}", flags.scene, to_string(technique), flags.size.width, flags.size.height,
                             flags.pixels == Pixels::display ? " display" : "")},
        {"renderer", session.context().renderer()},
        {"first_ns", std::chrono::duration_cast<std::chrono::nanoseconds>(first).count()}};
    print(header.dump() + "\n");
    if (by_lines) {
        for (std::string line; std::getline(std::cin, line);) {
            timed.print_batch(parse_frames(line, "standard input"));
        }
    } else {
        timed.print_batch(frames);
    }
    if (!flags.out.empty()) {
        write_file(flags.out, encode_png(timed.picture()));
    }
    return 0;
}

} // namespace

void add_time_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<TimeFlags>();
    add_scene(command, flags->scene);
    add_value(command, "--technique", "T", flags->technique, "Technique to time [per-pixel/blinn-phong]");
    add_own_files(command, flags->own, false);
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size of the frames [1280x720]");
    add_parsed(command, "--target", "float|display", flags->pixels, parse_pixels,
               "Draw into linear RGBA32F, as measured, or what a screen shows, 8 bits [float]");
    add_value(command, "--frames", "N|-", flags->frames, "Frames after the first; '-' reads counts from stdin [30]");
    add_value(command, "--out", "FILE.png", flags->out, "Write the last frame to this file");
    command.footer(
        R"(The first line is {"case", "renderer", "first_ns"}: first_ns is the monotonic clock, in nanoseconds,
when the first frame was finished. Each batch of frames adds a line {"ms": [...]}. A frame is: clear, draw,
finish.)");
    run_when_chosen(command, common, run, flags, run_time);
}

} // namespace sandbox
