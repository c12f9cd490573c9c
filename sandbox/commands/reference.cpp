#include "reference/reference.h"

#include "commands/commands.h"
#include "commands/progress_bar.h"
#include "image/image_file.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

struct ReferenceFlags {
    std::string scene, view;
    std::filesystem::path out;
    Technique technique;
    Size size = default_picture_size;
    std::string surface = "mesh";
};

int run_reference(const ReferenceFlags &flags, const CommonOptions &common) {
    const bool pfm = check_output(flags.out, {".png", ".pfm"}) == ".pfm";
    const Scene scene = open_scene(common, flags.scene, flags.view, flags.size);
    const std::vector<ObjectResources> resources = Resources(scene_assets(common)).load(scene);
    const Surface surface = flags.surface == "analytic" ? Surface::analytic : Surface::mesh;
    ProgressBar bar("reference " + flags.out.filename().string());
    const ReferenceFrame truth = with_flag("--surface " + flags.surface, [&] {
        return render_reference(scene, resources, flags.technique, flags.size, surface, [&](double share) {
            bar.report(share);
            return true;
        });
    });
    const Image picture = to_frame(truth).color;
    write_file(flags.out, pfm ? encode_pfm(picture) : encode_png(to_display(picture)));
    if (common.verbose) {
        note(fmt::format("reference: {:.1f} ms", truth.milliseconds));
    }
    return 0;
}

} // namespace

void add_reference_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<ReferenceFlags>();
    add_scene(command, flags->scene);
    add_value(command, "--out", "FILE", flags->out, "FILE.png (8 bit) or FILE.pfm (linear RGB in float32)")->required();
    add_parsed(command, "--technique", "T", flags->technique, parse_technique,
               "Technique to evaluate, in double precision [per-pixel/blinn-phong]");
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size of the picture [1280x720]");
    add_view_name(command, flags->view);
    add_choice(command, "--surface", {"mesh", "analytic"}, flags->surface,
               "Draw the triangles, or the exact shapes that they approximate (not for .obj) [mesh]");
    command.footer("Needs no OpenGL.");
    run_when_chosen(command, common, run, flags, run_reference);
}

} // namespace sandbox
