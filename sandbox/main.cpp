#include "commands/commands.h"
#include "commands/help.h"
#include "commands/interrupt.h"
#include "render/gl_program.h"

#include <cstdio>
#include <new>
#include <sstream>

namespace {

using namespace sandbox;

constexpr int bad_usage = 2;
constexpr int machine_lacks = 3;

/// --help and --version, or what was wrong with the command line; CLI11's own codes become ours.
int report_parse_end(const CLI::App &app, const CLI::ParseError &end) {
    std::ostringstream out, err;
    if (app.exit(end, out, err) == 0) {
        print(out.str());
        return 0;
    }
    const auto chosen = app.get_subcommands();
    const std::string help =
        chosen.empty() ? "shading-sandbox --help" : "shading-sandbox " + chosen[0]->get_name() + " --help";
    note(std::string(end.what()) + " (see: " + help + ")");
    return bad_usage;
}

int parse_and_run(int argc, char **argv) {
    CLI::App app("Lights a scene under several shading techniques at once, compares them and measures them.",
                 "shading-sandbox");
    app.set_version_flag("--version", std::string("shading-sandbox ") + SANDBOX_VERSION);
    app.require_subcommand(0, 1);
    CommonOptions common;
    Run run;
    std::string scene;
    app.add_option("SCENE", scene, "Without a command: the scene to open the window on");
    for (AddCommand *add : all_commands) {
        add(app, common, run);
    }
    add_common_options(app, common);
    app.footer(help_footer()); // last, or every command would inherit it
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &end) {
        return report_parse_end(app, end);
    }
    if (!run) {
        return view_scene(common, {scene, {}, {}});
    }
    if (!scene.empty()) {
        throw InputError("'" + scene + "' is neither a command nor an option (the command comes first)");
    }
    handle_interrupts();
    try {
        return run();
    } catch (const ShaderError &error) {
        if (common.shaders.empty()) {
            throw;
        }
        throw InputError(error.what()); // the user's own parts
    }
}

} // namespace

int main(int argc, char **argv) {
    try {
        return parse_and_run(argc, argv);
    } catch (const sandbox::InputError &error) {
        sandbox::note(error.what());
        return bad_usage;
    } catch (const std::bad_alloc &) {
        sandbox::note("not enough memory; a smaller --size needs less");
        return machine_lacks;
    } catch (const std::exception &error) {
        sandbox::note(error.what());
        return machine_lacks;
    }
}
