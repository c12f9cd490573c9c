#include "capture/figures.h"

#include "capture/figures_page.h"
#include "capture/opening_view.h"
#include "commands/commands.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/write_files.h"
#include "render/frame_clock.h"
#include "ui/views/painters.h"

#include <fmt/format.h>
#include <optional>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

struct FiguresFlags {
    std::string scene, view;
    std::filesystem::path out;
    std::optional<Technique> left, right;
    std::optional<Size> size;
    std::string language; ///< empty: the sidecar's, else English
};

/// What the figures show: the flags', else the sidecar's, else the scene's own comparison, else Blinn-Phong per vertex
/// and per pixel.
PictureOptions pair_of(const FiguresFlags &flags, const Scene &scene) {
    const std::optional<PictureOptions> sidecar = sidecar_of(flags.scene);
    const bool two_views = sidecar && (sidecar->layout != Layout::single || sidecar->flip != FlipSide::none);
    const OpeningView opening = opening_view(scene, flags.scene);
    PictureOptions pair;
    pair.left = flags.left.value_or(two_views ? sidecar->left
                                              : opening.left.value_or(Technique{.frequency = Frequency::per_vertex}));
    pair.right = flags.right.value_or(two_views ? sidecar->right : opening.right.value_or(Technique{}));
    if (sidecar) {
        pair.display = sidecar->display;
        pair.exposure = sidecar->exposure;
        pair.mesh_factors = sidecar->mesh_factors;
        pair.language = sidecar->language;
    }
    pair.language = flags.language.empty() ? pair.language : flags.language;
    pair.view = flags.view;
    return pair;
}

FigureRequest request_of(const FiguresFlags &flags, const CommonOptions &common) {
    FigureRequest request;
    request.name = flags.scene;
    request.view = flags.size.value_or(request.view);
    request.scene = open_scene(common, flags.scene, flags.view, request.view);
    if (request.scene.objects.empty()) {
        throw InputError("{}: objects: expected at least one, for figures of it", flags.scene);
    }
    request.pair = pair_of(flags, request.scene);
    request.scene_arguments = scene_arguments(common, flags.scene, flags.view);
    for (const auto &[flag, folder] : {std::pair("--assets", common.assets), std::pair("--shaders", common.shaders)}) {
        request.common_arguments += folder.empty() ? "" : fmt::format(" {} {}", flag, quoted(folder.string()));
    }
    request.folder = quoted((flags.out.has_filename() ? flags.out : flags.out.parent_path()).string());
    request.out = flags.out;
    request.words = words_in(request.pair.language, scene_assets(common));
    return request;
}

int run_figures(const FiguresFlags &flags, const CommonOptions &common) {
    const FigureRequest request = request_of(flags, common);
    make_folder("--out", flags.out, {"index.md"}); // before the work, not after it
    note_missing_font(request.pair.language, "pictures");
    DrawingSession session(common);
    Renderer &renderer = session.renderer();
    Target target(quick_plan().size);
    FrameClock clock(Context::software(), target, [&] { renderer.draw(request.scene, {}, target); });
    FigureDraw draw{[&](const Scene &scene) { return renderer.resources().load(scene); },
                    [&](const Scene &scene, const Technique &technique, Size size) {
                        return renderer.render(scene, technique, size, true);
                    },
                    painters_of(renderer, {}),
                    rows_drawn_by(renderer, target, clock),
                    {session.context().renderer(), session.context().version()},
                    this_machine()};
    draw.machine.renderer = session.context().renderer();
    draw.machine.clock = clock.name();
    note_no_effect(request.scene, request.pair.left, request.pair.right, draw.load(request.scene));
    std::vector<Figure> figures;
    {
        ProgressBar bar("figures " + flags.scene);
        figures = draw_figures(request, draw, [&](double share) {
            bar.report(share);
            return true;
        });
    }
    std::vector<OutputFile> files; // only now: an interrupt leaves what an earlier run wrote
    for (const Figure &figure : figures) {
        for (const FigureFile &file : figure.files) {
            files.push_back({flags.out / file.name, file.bytes});
        }
    }
    files.push_back({flags.out / "index.md", figures_page(request, draw, figures)});
    write_files(files);
    return 0;
}

} // namespace

void add_figures_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<FiguresFlags>();
    add_scene(command, flags->scene, "Built-in name, or path of a .json, sidecar or .obj file");
    add_value(command, "--out", "DIR", flags->out, "Folder for the files; made if it does not exist")->required();
    add_parsed(command, "--left", "T", flags->left, parse_technique,
               "Technique of A [the scene's comparison, else per-vertex/blinn-phong]");
    add_parsed(command, "--right", "T", flags->right, parse_technique,
               "Technique of B [the scene's comparison, else per-pixel/blinn-phong]");
    const auto parse = [](const std::string &text) {
        const Size size = parse_size(text);
        check_figure_size(size);
        return size;
    };
    add_parsed(command, "--size", "WxH", flags->size, parse, "Size of each view of A and B [640x480]");
    add_view_name(command, flags->view);
    add_language(command, flags->language, "Language of captions and labels [the sidecar's, else en]");
    command.footer(
        "Writes index.md, with captions, errors in levels of 8 bits and the commands that make each picture again, "
        "and\n"
        "  pair               A beside B\n"
        "  exponents          Phong over Blinn-Phong on a sphere, with shininess 2, 8, 32, 128\n"
        "  subdivision        per vertex on finer and finer meshes, and what each differs by from the truth;\n"
        "                     subdivision-error: the error against the number of triangles, with its order\n"
        "  difference         A - B, with its scale\n"
        "  profile            the luminance of A, B and the truth along the line in profile-line, through the pixel\n"
        "                     where A and B differ most\n"
        "  error-time         error against run time of A's model, as report --quick measures it\n"
        "Plots are SVG and PNG, pictures PNG with the sidecar that reproduces them. Nothing is written before all is\n"
        "made: Ctrl-C leaves the folder as it was.");
    run_when_chosen(command, common, run, flags, run_figures);
}

} // namespace sandbox
