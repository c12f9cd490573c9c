#include "commands/commands.h"

#include "capture/frame_names.h"
#include "capture/sidecar.h"
#include "commands/interrupt.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/image_file.h"
#include "scene/orbit.h"
#include "ui/views/painters.h"

#include <cmath>

namespace sandbox {
namespace {

/// As typed: absent where a sidecar's value or the default stands.
struct CaptureFlags {
    std::string scene, view;
    std::filesystem::path out;
    std::optional<Technique> technique, left, right;
    std::optional<Layout> layout;
    std::optional<Size> size;
    std::optional<Display> display;
    std::optional<double> gain, exposure, orbit;
    std::optional<int> frames;
    std::optional<DifferenceOf> difference_of;
    bool wireframe = false;
    bool labels = false;
    bool no_labels = false;
    bool no_sidecar = false;
};

void apply_one_view(const CaptureFlags &flags, PictureOptions &options) {
    if (flags.left || flags.right || flags.layout) {
        throw InputError("--technique is for one view; --left, --right and --layout are for two");
    }
    options.layout = Layout::single;
    options.flip = FlipSide::none;
    options.left = options.right = *flags.technique;
    options.textbook_left = false;
}

void apply_two_views(const CaptureFlags &flags, PictureOptions &options) {
    const bool two_already = options.layout != Layout::single;
    if (!two_already && !(flags.left && flags.right)) {
        throw InputError("two views need both --left and --right");
    }
    options.textbook_left = options.textbook_left && !flags.left;
    options.left = flags.left.value_or(options.left);
    options.right = flags.right.value_or(options.right);
    options.layout = flags.layout.value_or(two_already ? options.layout : Layout::side_by_side);
    if (options.layout == Layout::single) {
        throw InputError(
            "--layout: two views need side-by-side, wipe, difference or three-up; use --technique for one");
    }
    options.flip = FlipSide::none;
}

/// The sidecar's options, or the defaults, with what the flags change.
PictureOptions picture_options(const CaptureFlags &flags) {
    PictureOptions options = sidecar_of(flags.scene).value_or(PictureOptions{});
    if (flags.technique) {
        apply_one_view(flags, options);
    } else if (flags.left || flags.right || flags.layout) {
        apply_two_views(flags, options);
    }
    if ((flags.gain || flags.difference_of) && options.layout != Layout::difference) {
        throw InputError("{} needs --layout difference", flags.gain ? "--gain" : "--difference-of");
    }
    options.size = flags.size.value_or(options.size);
    options.display = flags.display.value_or(options.display);
    options.gain = flags.gain.value_or(options.gain);
    options.exposure = flags.exposure.value_or(options.exposure);
    options.difference_of = flags.difference_of.value_or(options.difference_of);
    options.wireframe = options.wireframe || flags.wireframe;
    options.labels = (options.labels || flags.labels) && !flags.no_labels;
    options.view = flags.view.empty() ? options.view : flags.view;
    check_positive("--gain", options.gain);
    check_positive("--exposure", options.exposure);
    view_sizes(options.layout, options.size); // refuses a view without a pixel
    return options;
}

void refuse_display_flags(const CaptureFlags &flags) {
    const std::pair<bool, const char *> display_flags[] = {{flags.display.has_value(), "--display"},
                                                           {flags.exposure.has_value(), "--exposure"},
                                                           {flags.gain.has_value(), "--gain"},
                                                           {flags.labels, "--labels"},
                                                           {flags.wireframe, "--wireframe"}};
    for (const auto &[given, flag] : display_flags) {
        if (given) {
            throw InputError("{}: a .pfm holds the linear values unchanged; use a .png", flag);
        }
    }
}

/// The number of files; 1 without --frames.
int frame_count(const CaptureFlags &flags) {
    const std::string out = flags.out.string();
    if (flags.frames.has_value() != flags.orbit.has_value()) {
        throw InputError("--frames N and --orbit DEGREES go together");
    }
    if (!flags.frames) {
        if (is_frame_pattern(flags.out.filename().string())) {
            throw InputError("--out: '{}' is a pattern, which needs --frames N --orbit DEGREES", out);
        }
        return 1;
    }
    if (*flags.frames < 1 || *flags.frames > 100000) {
        throw InputError("--frames: expected 1 to 100000, got {}", *flags.frames);
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
    PictureOptions options = picture_options(flags);
    options.labels = options.labels && !pfm;
    options.wireframe = options.wireframe && !pfm;
    Scene scene = open_scene(common, flags.scene, flags.view);
    const Camera camera = scene.camera;

    DrawingSession session(common);
    const DrawnBy by{session.context().renderer(), session.context().version()};
    const Painters painters = painters_of(session.renderer(), options.wireframe);
    if (options.layout == Layout::single || options.textbook_left) {
        note_no_effect(scene, options.textbook_left ? options.right : options.left);
    } else {
        note_no_effect(scene, options.left, options.right, session.renderer().resources().load(scene));
    }
    ProgressBar bar("capture " + flags.out.filename().string());
    for (int i = 0; i < frames; ++i) {
        scene.camera = orbit_camera(camera, orbit_degrees(flags.orbit.value_or(0), i, frames));
        const std::filesystem::path path(flags.frames ? frame_name(flags.out.string(), i) : flags.out.string());
        write_output(path, pfm ? encode_pfm(draw_picture(scene, options, painters))
                               : encode_png(show_picture(scene, options, painters)));
        if (!flags.no_sidecar) {
            write_output(sidecar_path(path), sidecar_text(scene, options, by));
        }
        bar.report((i + 1.0) / frames);
    }
    if (common.verbose) {
        note(fmt::format("programs built: {}", session.renderer().programs_built()));
    }
    return 0;
}

} // namespace

void add_capture(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App &command = *app.add_subcommand("capture", "Draw a scene into a picture file, without a window");
    const auto flags = std::make_shared<CaptureFlags>();
    add_scene(command, flags->scene, "Built-in name, or path of a .json, sidecar or .obj file");
    add_value(command, "--out", "FILE", flags->out,
              "FILE.png (8 bit) or FILE.pfm (linear RGB in float32, bottom row first)")
        ->required();
    add_parsed(command, "--technique", "T", flags->technique, parse_technique,
               "Technique of a single view [per-pixel/blinn-phong]");
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size of the whole picture [1280x720]");
    add_view_name(command, flags->view);
    add_parsed(command, "--display", "linear|srgb", flags->display, parse_display, "Transfer curve of a PNG [linear]");
    add_value(command, "--exposure", "E", flags->exposure,
              "Factor on the colours of a PNG, before the transfer curve [1]");
    command.add_flag("--wireframe", flags->wireframe, "Draw the triangles' edges over a PNG");
    command.add_flag("--labels", flags->labels, "Write the techniques in a strip above the views");
    command.add_flag("--no-labels", flags->no_labels, "No labels, even if the sidecar asks for them");
    command.add_flag("--no-sidecar", flags->no_sidecar,
                     "Do not write FILE.json, the sidecar that reproduces the picture");
    command.option_defaults()->group("Two views");
    add_parsed(command, "--left", "T", flags->left, parse_technique, "Technique of the left view, A");
    add_parsed(command, "--right", "T", flags->right, parse_technique, "Technique of the right view, B");
    add_parsed(command, "--layout", "LAYOUT", flags->layout, parse_layout,
               "side-by-side, wipe, difference or three-up, whose third view is the truth [side-by-side]");
    add_value(command, "--gain", "G", flags->gain, "Factor on a difference in a PNG [1]");
    add_parsed(command, "--difference-of", "a-b|a-reference|b-reference", flags->difference_of, parse_difference_of,
               "The two pictures of a difference; a reference is of that side's model [a-b]");
    command.option_defaults()->group("Turntable");
    add_value(command, "--frames", "N", flags->frames, "Number of frames; --out must contain %04d");
    add_value(command, "--orbit", "DEG", flags->orbit,
              "Total turn in degrees, about the target and the up axis; frame k is turned by DEG k/N");
    command.footer(
        "--size is the size of the whole file: strips with labels and scales first, then, side by side, each view has\n"
        "half the width, three-up a third, and the first ones have the columns that are left over. A difference is in "
        "a\n"
        "PNG G (left - right), orange where left is brighter, blue where right is, over a faint outline of the scene, "
        "and\n"
        "in a PFM left - right.");
    run_when_chosen(command, common, run, flags, run_capture);
}

} // namespace sandbox
