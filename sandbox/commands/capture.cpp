#include "commands/commands.h"

#include "capture/frame_names.h"
#include "capture/sidecar.h"
#include "commands/interrupt.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/image_file.h"
#include "measure/stability/textbook.h"
#include "scene/orbit.h"

#include <cmath>
#include <memory>
#include <optional>

namespace sandbox {
namespace {

/// As typed: absent where a sidecar's value or the default stands.
struct CaptureFlags {
    std::string scene;
    std::filesystem::path out;
    std::optional<std::string> technique, left, right, layout, size, display;
    std::string view;
    std::optional<double> gain, exposure, orbit;
    std::optional<int> frames;
    bool labels = false;
    bool no_labels = false;
    bool no_sidecar = false;
};

void apply_one_view(const CaptureFlags &flags, PictureOptions &options) {
    if (flags.left || flags.right || flags.layout) {
        throw InputError("--technique is one view; --left, --right and --layout are two");
    }
    options.layout = Layout::single;
    options.left = options.right = with_flag("--technique", [&] { return parse_technique(*flags.technique); });
    options.textbook_left = false;
}

void apply_two_views(const CaptureFlags &flags, PictureOptions &options) {
    const bool two_already = options.layout != Layout::single;
    if (!two_already && !(flags.left && flags.right)) {
        throw InputError("two views need both --left and --right");
    }
    if (flags.left) {
        options.left = with_flag("--left", [&] { return parse_technique(*flags.left); });
        options.textbook_left = false;
    }
    if (flags.right) {
        options.right = with_flag("--right", [&] { return parse_technique(*flags.right); });
    }
    if (flags.layout) {
        options.layout = with_flag("--layout", [&] { return parse_layout(*flags.layout); });
    } else if (!two_already) {
        options.layout = Layout::side_by_side;
    }
    if (options.layout == Layout::single) {
        throw InputError("--layout: two views need side-by-side, wipe or difference; use --technique for one");
    }
}

void apply_display(const CaptureFlags &flags, PictureOptions &options) {
    if (flags.display) {
        options.display = with_flag("--display", [&] { return parse_display(*flags.display); });
    }
    if (flags.gain && options.layout != Layout::difference) {
        throw InputError("--gain is of --layout difference");
    }
    options.gain = flags.gain.value_or(options.gain);
    options.exposure = flags.exposure.value_or(options.exposure);
    options.labels = (options.labels || flags.labels) && !flags.no_labels;
    check_positive("--gain", options.gain);
    check_positive("--exposure", options.exposure);
}

PictureOptions picture_options(const CaptureFlags &flags) {
    PictureOptions options = sidecar_of(flags.scene).value_or(PictureOptions{});
    if (flags.technique) {
        apply_one_view(flags, options);
    } else if (flags.left || flags.right || flags.layout) {
        apply_two_views(flags, options);
    }
    if (flags.size) {
        options.size = parse_size(*flags.size);
    }
    view_sizes(options.layout, options.size);
    apply_display(flags, options);
    if (!flags.view.empty()) {
        options.view = flags.view;
    }
    return options;
}

void refuse_display_flags(const CaptureFlags &flags) {
    const auto refuse = [](bool given, const char *flag) {
        if (given) {
            throw InputError(std::string(flag) + ": a .pfm holds the linear values as they are; use a .png");
        }
    };
    refuse(flags.display.has_value(), "--display");
    refuse(flags.exposure.has_value(), "--exposure");
    refuse(flags.gain.has_value(), "--gain");
    refuse(flags.labels, "--labels");
}

/// The number of files; 1 without --frames.
int frame_count(const CaptureFlags &flags) {
    const std::string out = flags.out.string();
    if (flags.frames.has_value() != flags.orbit.has_value()) {
        throw InputError("--frames N and --orbit DEGREES go together");
    }
    if (!flags.frames) {
        if (is_frame_pattern(flags.out.filename().string())) {
            throw InputError("--out: '" + out + "' is a pattern for --frames N --orbit DEGREES");
        }
        return 1;
    }
    if (*flags.frames < 1 || *flags.frames > 100000) {
        throw InputError("--frames: expected 1 to 100000, got " + std::to_string(*flags.frames));
    }
    if (!std::isfinite(*flags.orbit)) {
        throw InputError("--orbit: expected a finite number of degrees");
    }
    with_flag("--out", [&] { return frame_name(out, 0); });
    return *flags.frames;
}

int run_capture(const CaptureFlags &flags, const CommonOptions &common) {
    const bool pfm = check_output(flags.out, {".png", ".pfm"}) == ".pfm";
    if (pfm) {
        refuse_display_flags(flags);
    }
    const int frames = frame_count(flags);
    const PictureOptions options = picture_options(flags);
    Scene scene = open_scene(common, flags.scene, flags.view);
    const Camera camera = scene.camera;

    DrawingSession session(common);
    const DrawnBy by{session.context().renderer(), session.context().version()};
    const DrawView draw = [&](const Scene &s, const Technique &t, Size size) {
        return session.renderer().render(s, t, size).color;
    };
    const DrawView textbook = [&](const Scene &s, const Technique &t, Size size) {
        return textbook_picture(s, session.renderer().resources().load(s), t, size).color;
    };
    ProgressBar bar("capture " + flags.out.filename().string());
    for (int i = 0; i < frames; ++i) {
        scene.camera = orbit_camera(camera, orbit_degrees(flags.orbit.value_or(0), i, frames));
        const std::filesystem::path path(flags.frames ? frame_name(flags.out.string(), i) : flags.out.string());
        const Image linear = draw_picture(scene, options, draw, textbook);
        write_output(path, pfm ? encode_pfm(linear) : encode_png(show_picture(linear, options)));
        if (!flags.no_sidecar) {
            write_output(sidecar_path(path), sidecar_text(scene, options, by));
        }
        bar.report((i + 1.0) / frames);
    }
    if (common.verbose) {
        note("programs built: " + std::to_string(session.renderer().programs_built()));
    }
    return 0;
}

} // namespace

void add_capture(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("capture", "Draw a scene into a file, without a window");
    auto flags = std::make_shared<CaptureFlags>();
    command->add_option("SCENE", flags->scene, "Built-in name, .json (a sidecar too), or .obj")
        ->type_name("")
        ->required();
    command->add_option("--out", flags->out, "FILE.png (8 bit) or FILE.pfm (float32 linear RGB, bottom row first)")
        ->type_name("FILE")
        ->required();
    command->add_option("--technique", flags->technique, "One view [per-pixel/blinn-phong]")->type_name("T");
    command->add_option("--size", flags->size, "Of the whole picture [1280x720]")->type_name("WxH");
    command->add_option("--view", flags->view, "One of the scene's named views")->type_name("NAME");
    command->add_option("--display", flags->display, "Transfer curve of a PNG [linear]")->type_name("linear|srgb");
    command->add_option("--exposure", flags->exposure, "Multiplies before display [1]")->type_name("E");
    const std::string two = "Two views";
    command->add_option("--left", flags->left, "Technique of the left view, A")->type_name("T")->group(two);
    command->add_option("--right", flags->right, "Technique of the right view, B")->type_name("T")->group(two);
    command->add_option("--layout", flags->layout, "side-by-side, wipe or difference [side-by-side]")
        ->type_name("LAYOUT")
        ->group(two);
    command->add_option("--gain", flags->gain, "Of a difference in a PNG [1]")->type_name("G")->group(two);
    command->add_flag("--labels", flags->labels, "Write the techniques over the picture");
    command->add_flag("--no-labels", flags->no_labels, "Not even where the sidecar that is SCENE says so");
    const std::string turn = "Frames";
    command->add_option("--frames", flags->frames, "So many files; --out is a pattern, e.g. turn_%04d.png")
        ->type_name("N")
        ->group(turn);
    command
        ->add_option("--orbit", flags->orbit,
                     "The turn in all about the target and the up axis; frame k of N is at DEG k/N")
        ->type_name("DEG")
        ->group(turn);
    command->add_flag("--no-sidecar", flags->no_sidecar,
                      "Do not write FILE.json, which the picture can be made from again");
    command->footer(
        "--size is of the whole file: side by side each view has half the width, and the left one the extra\n"
        "column of an odd width. A difference in a PNG is G |left - right|, in a PFM left - right.");
    add_common_options(*command, common);
    command->callback([flags, &common, &run] { run = [flags, &common] { return run_capture(*flags, common); }; });
}

} // namespace sandbox
