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

} // namespace

int view_scene(const CommonOptions &common, const std::string &name) {
    WindowOptions options;
    options.assets = scene_assets(common);
    options.shaders = shader_assets(common);
    const std::string shown = name.empty() ? std::string(first_scene) : name;
    options.file = open_file(shown, options.assets); // a wrong name is said before a display is looked for
    options.file.scene = open_scene(common, shown);  // with every --set
    if (!has_display_server()) {
        throw MachineError("no display server (DISPLAY and WAYLAND_DISPLAY are unset), so no window can open. Use "
                           "`shading-sandbox capture SCENE --out FILE.png` for pictures without a window, or run.sh");
    }
    return run_window(options);
}

void add_view(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("view", "Open the window (as no command does)");
    auto scene = std::make_shared<std::string>();
    command->add_option("SCENE", *scene, "Built-in name, .json (a sidecar too) or .obj")->type_name("");
    add_common_options(*command, common);
    command->callback([scene, &common, &run] { run = [scene, &common] { return view_scene(common, *scene); }; });
}

} // namespace sandbox
