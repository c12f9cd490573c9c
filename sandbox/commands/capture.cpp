#include "commands/commands.h"

#include "capture/frame_names.h"
#include "capture/grid.h"
#include "capture/pack.h"
#include "capture/picture_ranges.h"
#include "capture/samples.h"
#include "capture/sidecar.h"
#include "commands/own_flags.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/image_file.h"
#include "image/number.h"
#include "scene/budget.h"
#include "scene/orbit.h"
#include "scene/read_json.h"
#include "scene/scene_setting.h"
#include "ui/views/painters.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

/// As typed, till own shading is read.
struct TypedTechniques {
    std::vector<std::string> single;
    std::optional<std::string> left, right;
    OwnFlags own;
};

/// As typed: absent where a sidecar's value or the default stands.
struct CaptureFlags {
    TypedTechniques typed;
    std::string scene, view;
    std::filesystem::path out, pack;
    std::vector<Technique> techniques;
    std::optional<Technique> left, right;
    std::optional<Sweep> sweep;
    std::optional<Layout> layout;
    std::optional<Size> size;
    std::optional<Display> display;
    std::optional<double> gain, exposure, orbit, samples;
    std::optional<int> frames;
    std::optional<DifferenceOf> difference_of;
    std::optional<MeshFactors> mesh_factors;
    std::optional<glm::dvec2> pixel;
    std::optional<double> profile;
    bool vectors = false;
    bool loupe = false;
    Overlays overlays;
    bool masks = false;
    bool labels = false;
    bool no_labels = false;
    std::string language; ///< empty: the sidecar's, else English
    bool no_sidecar = false;
};

void apply_one_view(const CaptureFlags &flags, PictureOptions &options) {
    if (flags.left || flags.right || flags.layout) {
        throw InputError("--technique is for one view; --left, --right and --layout are for two");
    }
    options.layout = Layout::single;
    options.flip = FlipSide::none;
    options.left = options.right = flags.techniques.front();
    options.textbook_left = false;
    options.mesh_factors = {1, 1};
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

double parse_share(std::string_view text) {
    double share = -1;
    const auto [end, error] = read_number(text.data(), text.data() + text.size(), share);
    if (error != std::errc() || end != text.data() + text.size() || !(share >= 0 && share <= 1)) {
        throw InputError("expected a share of the view from 0 to 1, got '{}'", text);
    }
    return share;
}

/// One for both views, or that of A and that of B.
MeshFactors parse_mesh_factors(std::string_view text) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const double left = parse_mesh_factor(text.substr(0, comma));
    return {left, comma == text.size() ? left : parse_mesh_factor(text.substr(comma + 1))};
}

glm::dvec2 parse_place(std::string_view text) {
    const std::size_t comma = std::min(text.find(','), text.size());
    return {parse_share(text.substr(0, comma)), parse_share(text.substr(std::min(comma + 1, text.size())))};
}

void take_marks(Marks &marks, const CaptureFlags &flags) {
    marks.pixel = flags.pixel ? flags.pixel : marks.pixel;
    marks.profile = flags.profile ? flags.profile : marks.profile;
    marks.vectors = marks.vectors || flags.vectors;
    marks.loupe = marks.loupe || flags.loupe;
    if (!marks.pixel && (marks.vectors || marks.loupe)) {
        throw InputError("{} needs --pixel X,Y", marks.vectors ? "--vectors" : "--loupe");
    }
}

/// The sidecar's options, or the defaults, with what the flags change.
PictureOptions picture_options(const CaptureFlags &flags) {
    PictureOptions options = sidecar_of(flags.scene).value_or(PictureOptions{});
    if (flags.techniques.size() > 1 && !flags.sweep) {
        throw InputError("--technique: one, unless --sweep puts more under each other");
    }
    if (!flags.techniques.empty()) {
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
    options.mesh_factors = flags.mesh_factors.value_or(options.mesh_factors);
    options.difference_of = flags.difference_of.value_or(options.difference_of);
    options.samples =
        flags.samples ? with_flag("--samples", [&] { return checked_samples(*flags.samples); }) : options.samples;
    for (const OverlayKind &kind : overlay_kinds) {
        options.drawn_over.*kind.on = options.drawn_over.*kind.on || flags.overlays.*kind.on;
    }
    for (const OverlayKind &kind : overlay_kinds) {
        const bool allowed = kind.in_difference || kind.on == &Overlays::lights;
        if (options.layout == Layout::difference && !allowed && flags.overlays.*kind.on) {
            throw InputError("--{}: a difference shows what is measured, and has the wireframe at most", kind.word);
        }
    }
    options.masks = options.masks || flags.masks;
    take_marks(options.marks, flags);
    const bool difference = options.layout == Layout::difference;
    if (flags.masks && difference) {
        throw InputError("--masks: a difference shows no masks");
    }
    options.masks = options.masks && !difference;
    const bool one_sample = difference || options.marks.loupe || options.masks;
    if (flags.samples && one_sample) {
        throw InputError("--samples: a difference, masks and a loupe show what is measured, one sample a pixel");
    }
    options.samples = one_sample ? 1 : options.samples;
    options.labels = (options.labels || flags.labels) && !flags.no_labels;
    options.language = flags.language.empty() ? options.language : flags.language;
    note_missing_font(options.language, "labels");
    options.view = flags.view.empty() ? options.view : flags.view;
    with_flag("--gain", [&] { checked_number(options.gain, gain_range); });
    with_flag("--exposure", [&] { checked_number(options.exposure, exposure_range); });
    view_sizes(options.layout, options.size); // refuses a view without a pixel
    if (options.samples > 1) {
        with_flag("--samples", [&] { check_sampled(options.size); });
    }
    return options;
}

void refuse_display_flags(const CaptureFlags &flags) {
    const std::pair<bool, const char *> display_flags[] = {{flags.display.has_value(), "--display"},
                                                           {flags.exposure.has_value(), "--exposure"},
                                                           {flags.gain.has_value(), "--gain"},
                                                           {flags.samples.has_value(), "--samples"},
                                                           {flags.labels, "--labels"},
                                                           {flags.vectors, "--vectors"},
                                                           {flags.loupe, "--loupe"},
                                                           {flags.profile.has_value(), "--profile-at"},
                                                           {flags.masks, "--masks"}};
    const auto refuse = [](bool given, std::string_view flag) {
        if (given) {
            throw InputError("{}: a .pfm holds the linear values unchanged; use a .png", flag);
        }
    };
    for (const auto &[given, flag] : display_flags) {
        refuse(given, flag);
    }
    for (const OverlayKind &kind : overlay_kinds) {
        refuse(flags.overlays.*kind.on, fmt::format("--{}", kind.word));
    }
}

/// The flags', or the turntable that SCENE is the sidecar of, if --out asks for many files.
std::optional<Turntable> turntable(const CaptureFlags &flags) {
    const bool many = is_frame_pattern(flags.out.filename().string());
    const auto recorded = many && sidecar_of(flags.scene)
                              ? turntable_of(read_file(flags.scene, largest_json), flags.scene)
                              : std::optional<Turntable>{};
    if (!recorded && flags.frames.has_value() != flags.orbit.has_value()) {
        throw InputError("--frames N and --orbit DEGREES go together");
    }
    if (!recorded && !flags.frames) {
        if (many) {
            throw InputError("--out: '{}' is a pattern, which needs --frames N --orbit DEGREES", flags.out.string());
        }
        return std::nullopt;
    }
    Turntable turntable = recorded.value_or(Turntable{});
    turntable.frames =
        flags.frames ? with_flag("--frames", [&] { return checked_frames(*flags.frames); }) : turntable.frames;
    turntable.degrees =
        with_flag("--orbit", [&] { return checked_number(flags.orbit.value_or(turntable.degrees), rotation); });
    with_flag("--out", [&] { return frame_name(flags.out.string(), 0); });
    return turntable;
}

/// The one that SCENE is the sidecar of, if --out asks for many files and no turntable.
std::optional<Motion> recorded_motion(const CaptureFlags &flags) {
    const bool many = is_frame_pattern(flags.out.filename().string());
    if (!many || flags.frames || flags.orbit || !sidecar_of(flags.scene)) {
        return std::nullopt;
    }
    with_flag("--out", [&] { return frame_name(flags.out.string(), 0); });
    return motion_of(read_file(flags.scene, largest_json), flags.scene);
}

/// What a grid is not made of, or cannot be.
void refuse_beside_sweep(const CaptureFlags &flags, bool pfm) {
    const std::pair<bool, const char *> refused[] = {
        {flags.left || flags.right || flags.layout,
         "--left, --right and --layout are for two views; a grid has --technique"},
        {flags.frames || flags.orbit || is_frame_pattern(flags.out.filename().string()),
         "a grid is one picture, without --frames"},
        {flags.no_labels, "a grid has labels"},
        {pfm, "a grid is for a .png"}};
    for (const auto &[given, why] : refused) {
        if (given) {
            throw InputError("--sweep: {}", why);
        }
    }
}

/// The flags', or the grid that SCENE is the sidecar of, unless the flags ask for something else.
std::optional<Grid> asked_grid(const CaptureFlags &flags, const PictureOptions &options, bool pfm) {
    if (flags.sweep) {
        refuse_beside_sweep(flags, pfm);
        return Grid{flags.techniques.empty() ? std::vector{options.left} : flags.techniques, *flags.sweep};
    }
    const bool other = pfm || !flags.techniques.empty() || flags.left || flags.right || flags.layout || flags.frames;
    std::error_code ignored;
    const std::filesystem::path path(flags.scene);
    const bool file = path.extension() == ".json" && std::filesystem::is_regular_file(path, ignored);
    return file && !other
               ? grid_of(read_file(path, largest_json), flags.scene, std::filesystem::absolute(path).parent_path())
               : std::nullopt;
}

CaptureFlags with_techniques(CaptureFlags flags) {
    OwnTechniques techniques(flags.typed.own);
    for (const std::string &text : flags.typed.single) {
        flags.techniques.push_back(techniques.single("--technique", text));
    }
    if (flags.typed.left) {
        flags.left = techniques.left(*flags.typed.left);
    }
    if (flags.typed.right) {
        flags.right = techniques.right(*flags.typed.right);
    }
    techniques.require_all_used();
    return flags;
}

/// --pack: --out is in its folder, which is made.
CaptureFlags in_pack(CaptureFlags flags) {
    if (flags.pack.empty()) {
        return flags;
    }
    if (flags.no_sidecar) {
        throw InputError("--pack: the sidecar is what needs the files; it cannot go with --no-sidecar");
    }
    if (flags.out.has_parent_path()) {
        throw InputError("--pack: --out names a file in that folder, such as a.png, got '{}'", flags.out.string());
    }
    make_folder("--pack", flags.pack, {});
    flags.out = flags.pack / flags.out;
    return flags;
}

std::filesystem::path file_of(const CaptureFlags &flags, int frame, bool many) {
    return many ? frame_name(flags.out.string(), frame) : flags.out.string();
}

/// What the folder of --pack gets beside the pictures and their sidecar. Throws InputError if it holds other files.
Pack pack_for(const CaptureFlags &flags, const Scene &scene, const PictureOptions &options,
              const std::optional<Grid> &grid, const Assets &assets, int frames, bool many) {
    std::set<std::string> names{sidecar_path(flags.out).filename().string()};
    for (int i = 0; i < frames; ++i) {
        names.insert(file_of(flags, i, many).filename().string());
    }
    Pack pack = pack_of(scene, options, grid, assets, flags.pack, names);
    for (const OutputFile &file : pack.files) {
        names.insert(file.path.filename().string());
    }
    with_flag("--pack", [&] { refuse_other_files(flags.pack, names); });
    return pack;
}

int run_capture(const CaptureFlags &typed, const CommonOptions &common) {
    const CaptureFlags flags = in_pack(with_techniques(typed));
    const bool pfm = check_output(flags.out, {".png", ".pfm"}) == ".pfm";
    if (!flags.no_sidecar) {
        check_writable(sidecar_path(flags.out));
    }
    if (pfm) {
        refuse_display_flags(flags);
    }
    PictureOptions options = picture_options(flags);
    const std::optional<Grid> grid = asked_grid(flags, options, pfm);
    const std::optional<Motion> motion = recorded_motion(flags);
    const std::optional<Turntable> turn = motion ? std::optional<Turntable>{} : turntable(flags);
    options = grid ? cell_options(options, grid->techniques.front()) : options;
    options.labels = options.labels && !pfm;
    options.drawn_over = pfm ? Overlays{} : options.drawn_over;
    options.masks = options.masks && !pfm;
    options.samples = pfm ? 1 : options.samples;
    const Scene scene = open_scene(common, flags.scene, flags.view, view_sizes(options.layout, options.size).back());

    DrawingSession session(common);
    const DrawnBy by{session.context().renderer(), session.context().version()};
    const Painters painters = painters_of(session.renderer(), on_surfaces(options.drawn_over, options.layout));
    const bool two_meshes = options.mesh_factors[0] != options.mesh_factors[1]; // never the same picture
    if (options.layout == Layout::single || options.textbook_left || two_meshes) {
        note_no_effect(scene, options.textbook_left || options.flip == FlipSide::b ? options.right : options.left);
    } else {
        note_no_effect(scene, options.left, options.right, session.renderer().resources().load(scene));
    }
    ProgressBar bar("capture " + flags.out.filename().string());
    const int frames = motion ? moments_of(*motion) : turn ? turn->frames : 1;
    const bool many = motion || turn;
    const Pack pack = flags.pack.empty() ? Pack{scene, options, grid, {}}
                                         : pack_for(flags, scene, options, grid, scene_assets(common), frames, many);
    const std::filesystem::path folder = std::filesystem::absolute(flags.out).parent_path();
    std::string sidecar = sidecar_text(pack.scene, pack.options, by, folder);
    sidecar = grid     ? grid_text(sidecar, *pack.grid, folder)
              : motion ? motion_sidecar(sidecar, *motion)
              : turn   ? turntable_text(sidecar, *turn)
                       : sidecar;
    for (int i = 0; i < frames; ++i) {
        Scene now = motion ? moved(scene, *motion, i) : scene;
        now.camera = turn ? orbit_camera(now.camera, orbit_degrees(turn->degrees, i, frames)) : now.camera;
        const auto draw_cells = [&] {
            return draw_grid(now, *grid, options, painters, "--sweep", [&](double share) {
                bar.report(share);
                return true;
            });
        };
        std::vector<OutputFile> files{
            {file_of(flags, i, many), grid  ? encode_png(with_flag("--sweep", draw_cells))
                                      : pfm ? encode_pfm(draw_picture(now, options, painters))
                                            : encode_png(show_picture(now, options, painters))}};
        if (i == 0 && !flags.no_sidecar) {
            files.push_back({sidecar_path(flags.out), sidecar});
            files.insert(files.end(), pack.files.begin(), pack.files.end());
        }
        write_files(files);
        bar.report((i + 1.0) / frames);
    }
    if (common.verbose) {
        note(fmt::format("programs built: {}", session.renderer().programs_built()));
    }
    return 0;
}

} // namespace

void add_capture_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<CaptureFlags>();
    add_scene(command, flags->scene, "Built-in name, or path of a .json, sidecar or .obj file");
    add_value(command, "--out", "FILE", flags->out,
              "FILE.png (8 bit) or FILE.pfm (linear RGB in float32, bottom row first)")
        ->required();
    add_value(command, "--technique", "T", flags->typed.single,
              "Technique of a single view [per-pixel/blinn-phong]; repeatable with --sweep")
        ->allow_extra_args(false);
    add_own_files(command, flags->typed.own, true);
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size of the whole picture [1280x720]");
    add_view_name(command, flags->view);
    add_parsed(command, "--display", "linear|srgb", flags->display, parse_display, "Transfer curve of a PNG [linear]");
    add_value(command, "--exposure", "E", flags->exposure,
              "Factor on the colours of a PNG, before the transfer curve [1]");
    add_parsed(command, "--mesh-factor", "F|A,B", flags->mesh_factors, parse_mesh_factors,
               "Coarser or finer meshes: factor on rings, segments and divisions, of all views or of A and of B, such "
               "as 1/4,4 [1]");
    add_value(command, "--samples", "N", flags->samples,
              "Sub-pixel samples of a PNG, for pictures to show: measured is 1 [1]");
    for (const OverlayKind &kind : overlay_kinds) {
        command.add_flag(fmt::format("--{}", kind.word), flags->overlays.*kind.on,
                         fmt::format("Draw over a PNG {}", kind.help));
    }
    command.add_flag("--masks", flags->masks,
                     "In a PNG of views: which pixels error figures leave out, in colours with a legend");
    command.add_flag("--labels", flags->labels, "Write the techniques in a strip above the views");
    add_language(command, flags->language, "Language of labels [the sidecar's, else en]");
    command.add_flag("--no-labels", flags->no_labels, "No labels, even if the sidecar asks for them");
    command.add_flag("--no-sidecar", flags->no_sidecar,
                     "Do not write FILE.json, the sidecar that reproduces the picture");
    add_value(command, "--pack", "DIR", flags->pack,
              "Write --out, its sidecar and copies of the textures, models and own shading that it needs into this\n"
              "folder, which can be moved as a whole");
    command.option_defaults()->group("Two views");
    add_value(command, "--left", "T", flags->typed.left, "Technique of the left view, A");
    add_value(command, "--right", "T", flags->typed.right, "Technique of the right view, B");
    add_parsed(command, "--layout", "LAYOUT", flags->layout, parse_layout,
               "side-by-side, wipe, difference or three-up, whose third view is the truth [side-by-side]");
    add_value(command, "--gain", "G", flags->gain, "Factor on a difference in a PNG [1]");
    add_parsed(command, "--difference-of", "a-b|a-reference|b-reference", flags->difference_of, parse_difference_of,
               "The two pictures of a difference; a reference is of that side's model [a-b]");
    command.option_defaults()->group("Marks over every view of a PNG");
    add_parsed(command, "--pixel", "X,Y", flags->pixel, parse_place,
               "Which pixel, as shares of a view's width and height, from its upper left corner");
    command.add_flag("--vectors", flags->vectors, "A cross at --pixel, and its N, V and every light's L and R or H");
    command.add_flag("--loupe", flags->loupe, "The neighbourhood of --pixel, magnified");
    add_parsed(command, "--profile-at", "Y", flags->profile, parse_share, "A line at this share of the height");
    command.option_defaults()->group("Grid");
    add_parsed(command, "--sweep", "PATH=v1,v2,...", flags->sweep, parse_sweep,
               "A labelled grid: techniques down, values of a setting across, each cell --size; at most 64 cells");
    command.option_defaults()->group("Turntable");
    add_value(command, "--frames", "N", flags->frames,
              "Number of frames; --out must contain %04d, and its sidecar is of all frames");
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
