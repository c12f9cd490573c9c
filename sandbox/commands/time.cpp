#include "commands/commands.h"

#include "commands/interrupt.h"
#include "commands/session.h"
#include "image/image_file.h"
#include "scene/scene_file.h"

#include <charconv>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace sandbox {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int most_frames = 1000000;

struct TimeFlags {
    std::string scene;
    std::string technique{default_technique};
    std::string size{default_size};
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
        throw InputError(std::string(where) + ": expected a number of frames from 1 to 1000000, got '" +
                         std::string(text) + "'");
    }
    return frames;
}

/// One scene under one technique, drawn again and again into the same target.
class TimedFrames {
  public:
    TimedFrames(Renderer &renderer, const Scene &scene, const Technique &technique, Size size)
        : renderer_(renderer), scene_(scene), technique_(technique), target_(size) {}

    /// Clear, draw, finish; the wall clock in milliseconds.
    double draw() {
        const Clock::time_point start = Clock::now();
        renderer_.draw(scene_, technique_, target_);
        Renderer::finish();
        return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
    void print_batch(int frames) {
        std::vector<double> milliseconds(static_cast<std::size_t>(frames));
        for (double &ms : milliseconds) {
            ms = draw();
        }
        print(nlohmann::json{{"ms", milliseconds}}.dump() + "\n");
    }
    [[nodiscard]] Image picture() const { return target_.read_color(); }

  private:
    Renderer &renderer_;
    const Scene &scene_;
    Technique technique_;
    Target target_;
};

int run_time(const TimeFlags &flags, const CommonOptions &common) {
    if (!flags.out.empty()) {
        check_output(flags.out, {".png"});
    }
    const bool by_lines = flags.frames == "-";
    const int frames = by_lines ? 0 : parse_frames(flags.frames, "--frames");
    const Technique technique = with_flag("--technique", [&] { return parse_technique(flags.technique); });
    const Size size = parse_size(flags.size);
    const Scene scene = open_scene(common, flags.scene);

    DrawingSession session(common);
    TimedFrames timed(session.renderer(), scene, technique, size);
    timed.draw();
    const auto first = Clock::now().time_since_epoch();
    const nlohmann::ordered_json header{
        {"case", flags.scene + " " + to_string(technique) + " " + flags.size},
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
        write_output(flags.out, encode_png(to_display(timed.picture())));
    }
    return 0;
}

} // namespace

void add_time(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("time", "Run time of finished frames, as JSON lines");
    auto flags = std::make_shared<TimeFlags>();
    command->add_option("SCENE", flags->scene, "Built-in name, .json or .obj")->type_name("")->required();
    command->add_option("--technique", flags->technique, "What to time")->type_name("T")->capture_default_str();
    command->add_option("--size", flags->size, "Of the frames")->type_name("WxH")->capture_default_str();
    command
        ->add_option("--frames", flags->frames,
                     "How many after the first; -: as many as each line of standard input says, until it ends")
        ->type_name("N|-")
        ->capture_default_str();
    command->add_option("--out", flags->out, "The last frame, as PNG, at the end")->type_name("FILE.png");
    command->footer(
        "First line: {\"case\", \"renderer\", \"first_ns\"}; first_ns is the monotonic clock in nanoseconds when the\n"
        "first frame was finished. Then {\"ms\": [...]} for each batch. A frame is clear, draw, finish.");
    add_common_options(*command, common);
    command->callback([flags, &common, &run] { run = [flags, &common] { return run_time(*flags, common); }; });
}

} // namespace sandbox
