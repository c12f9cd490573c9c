#include "commands/commands.h"
#include "ui/window.h"

#include <cstdlib>
#include <memory>

namespace sandbox {
namespace {

constexpr std::string_view first_scene = "three-point-lights";

bool has_display_server() {
    const auto set = [](const char *name) {
        const char *value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

void take_technique(std::optional<Technique> &technique, const char *flag, const std::optional<std::string> &text) {
    if (text) {
        technique = with_flag(flag, [&] { return parse_technique(*text); });
    }
}

} // namespace

int view_scene(const CommonOptions &common, const ViewFlags &flags) {
    WindowOptions options;
    options.assets = scene_assets(common);
    options.shaders = shader_assets(common);
    const std::string shown = flags.scene.empty() ? std::string(first_scene) : flags.scene;
    options.file = open_file(shown, options.assets); // a wrong name is said before a display is looked for
    options.file.scene = open_scene(common, shown);  // with every --set
    take_technique(options.file.left, "--left", flags.left);
    take_technique(options.file.right, "--right", flags.right);
    options.file.textbook_left = options.file.textbook_left && !flags.left;
    if (!has_display_server()) {
        throw MachineError("no display server (DISPLAY and WAYLAND_DISPLAY are unset), so no window can open. Use "
                           "`shading-sandbox capture SCENE --out FILE.png` for pictures without a window, or run.sh");
    }
    return run_window(options);
}

void add_view(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("view", "Open the window (as no command does)");
    auto flags = std::make_shared<ViewFlags>();
    command->add_option("SCENE", flags->scene, "Built-in name, .json (a sidecar too) or .obj")->type_name("");
    command->add_option("--left", flags->left, "Technique of the left view, A [per-vertex/phong]")->type_name("T");
    command->add_option("--right", flags->right, "Technique of the right view, B [per-pixel/blinn-phong]")
        ->type_name("T");
    add_common_options(*command, common);
    command->callback([flags, &common, &run] { run = [flags, &common] { return view_scene(common, *flags); }; });
}

} // namespace sandbox
