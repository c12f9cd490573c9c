#include "reference/reference.h"

#include "commands/commands.h"
#include "commands/interrupt.h"
#include "commands/progress_bar.h"
#include "image/image_file.h"

#include <memory>

namespace sandbox {
namespace {

struct ReferenceFlags {
    std::string scene;
    std::filesystem::path out;
    std::string technique{default_technique};
    std::string size{default_size};
    std::string view;
    std::string surface = "mesh";
};

int run_reference(const ReferenceFlags &flags, const CommonOptions &common) {
    const bool pfm = check_output(flags.out, {".png", ".pfm"}) == ".pfm";
    const Technique technique = with_flag("--technique", [&] { return parse_technique(flags.technique); });
    const Size size = parse_size(flags.size);
    const Scene scene = open_scene(common, flags.scene, flags.view);
    const std::vector<ObjectResources> resources = Resources(scene_assets(common)).load(scene);
    ProgressBar bar("reference " + flags.out.filename().string());
    const ReferenceFrame truth = with_flag("--surface " + flags.surface, [&] {
        return render_reference(scene, resources, technique, size,
                                flags.surface == "analytic" ? Surface::analytic : Surface::mesh, [&](double share) {
                                    bar.report(share);
                                    return true;
                                });
    });
    const Image picture = to_frame(truth).color;
    write_output(flags.out, pfm ? encode_pfm(picture) : encode_png(to_display(picture)));
    if (common.verbose) {
        note("reference: " + std::to_string(truth.milliseconds) + " ms");
    }
    return 0;
}

} // namespace

void add_reference(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("reference", "The double-precision image of the same equation, on the CPU");
    auto flags = std::make_shared<ReferenceFlags>();
    command->add_option("SCENE", flags->scene, "Built-in name, .json or .obj")->type_name("")->required();
    command->add_option("--out", flags->out, "FILE.png (8 bit) or FILE.pfm (float32 linear RGB)")
        ->type_name("FILE")
        ->required();
    command->add_option("--technique", flags->technique, "Evaluated where it says, in double")
        ->type_name("T")
        ->capture_default_str();
    command->add_option("--size", flags->size, "Of the picture")->type_name("WxH")->capture_default_str();
    command->add_option("--view", flags->view, "One of the scene's named views")->type_name("NAME");
    command->add_option("--surface", flags->surface, "The triangles, or the shapes they stand for (not for OBJ)")
        ->type_name("mesh|analytic")
        ->check(CLI::IsMember({"mesh", "analytic"}).description(""))
        ->capture_default_str();
    command->footer("Needs no OpenGL.");
    add_common_options(*command, common);
    command->callback([flags, &common, &run] { run = [flags, &common] { return run_reference(*flags, common); }; });
}

} // namespace sandbox
