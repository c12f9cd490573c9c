#include "commands/commands.h"

#include "shading/technique.h"
#include "words/words.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox {

/// Adds a command's options and its help, and what to run. Each is defined in the file of the command's name.
using AddOptions = void(CLI::App &command, CommonOptions &common, Run &run);
AddOptions add_list_options, add_capture_options, add_reference_options, add_compare_options, add_time_options,
    add_report_options, add_stability_options, add_lesson_options, add_figures_options, add_own_options,
    add_own_server_options, add_diagnose_options, add_mark_options, add_glsl_options, add_view_options;
AddOptions add_window; ///< to the program itself: without a command, SCENE opens in the window

struct Command {
    const char *name;
    const char *description; ///< empty: not listed, for other commands start it
    AddOptions *add_options;
};

constexpr Command commands[] = {
    {"list", "List built-in scenes, lessons, famous bugs, exercises, techniques and stability cases", add_list_options},
    {"capture", "Draw a scene into a picture file, without a window", add_capture_options},
    {"reference", "Draw a scene in double precision, on the CPU", add_reference_options},
    {"compare", "Measure how far one picture of a scene is from another", add_compare_options},
    {"time", "Time finished frames; prints JSON lines", add_time_options},
    {"report", "Measure error against run time: report.html, report.json, report.csv", add_report_options},
    {"stability", "Run the stiff and extreme cases: stability.html, stability.json, stability.csv",
     add_stability_options},
    {"lesson", "Measure the claims of a lesson, and write it as a page", add_lesson_options},
    {"figures", "Draw, measure and caption the figures of a hand-in: index.md, PNG and SVG files", add_figures_options},
    {"own", "Print a file of own shading: one to begin with, or the answer", add_own_options},
#ifndef __EMSCRIPTEN__ // a page starts no process
    {"own-server", "", add_own_server_options},
#endif
    {"diagnose", "Say what a picture of a scene is: technique, faults, conventions", add_diagnose_options},
    {"mark", "Give points to answers to an exercise, term by term", add_mark_options},
    {"glsl", "Print the GLSL program that draws a scene with a technique", add_glsl_options},
    {"view", "Open the window (the default without a command)", add_view_options},
};

/// A command's options are added when its name was read: no process describes commands that it does not run.
void add_commands(CLI::App &app, CommonOptions &common, Run &run) {
    for (const Command &row : commands) {
        CLI::App &command = *app.add_subcommand(row.name, row.description);
        if (*row.description == '\0') {
            command.group("");
        }
        command.preparse_callback([&, add_options = row.add_options](std::size_t) {
            add_options(command, common, run);
            add_common_options(command, common);
            const std::string footer = command.get_footer();
            command.footer(footer + (footer.empty() ? "" : "\n") +
                           "shading-sandbox --help explains SCENE, techniques and exit codes.");
        });
    }
    add_window(app, common, run);
}

std::string help_footer() {
    std::string text = "Technique T: FREQUENCY/MODEL[:key=value[,key=value]], e.g. per-vertex/phong or\n"
                       "per-pixel/blinn-phong:power=textbook. The first value of a key is its default; a key that can\n"
                       "have no effect under the frequency or model is refused.\n";
    for (const TechniqueKey &key : technique_keys()) {
        text += fmt::format("  {}: {}\n", key.name, key.doc);
        for (const TechniqueValue &value : key.values) {
            text += fmt::format("    {:<21} {}\n", value.name, value.look_for);
        }
    }
    text += fmt::format("  {}: {}\n", tolerance_name, tolerance_doc);
    return text +
           "\nSCENE is the name of a built-in scene (see: shading-sandbox list), or the path of a scene (.json),\n"
           "of a picture's sidecar (.png.json) or of a mesh (.obj).\n"
           "Each command has its own --help.\n"
           "Exit codes: 0 success; 1 a check failed; 2 bad usage or bad input; 3 the machine lacks something,\n"
           "such as OpenGL 3.3; 130 interrupted.";
}

void add_scene(CLI::App &command, std::string &scene, const std::string &description) {
    add_value(command, "SCENE", "", scene, description)->required();
}

void add_view_name(CLI::App &command, std::string &view) {
    add_value(command, "--view", "NAME", view, "Use the camera of this named view of the scene");
}

CLI::Option *add_choice(CLI::App &command, const std::string &option, const std::vector<std::string> &words,
                        std::string &value, const std::string &description) {
    const auto parse = [words](const std::string &text) {
        if (std::ranges::find(words, text) == words.end()) {
            throw InputError("expected {}, got '{}'", fmt::join(words, " or "), text);
        }
        return text;
    };
    return add_parsed(command, option, fmt::format("{}", fmt::join(words, "|")), value, parse, description);
}

CLI::Option *add_language(CLI::App &command, std::string &language, const std::string &description) {
    return add_choice(command, "--lang", {languages.begin(), languages.end()}, language, description);
}

void add_common_options(CLI::App &command, CommonOptions &common) {
    const auto add_settings = [&common](const std::vector<std::string> &settings) {
        common.settings.insert(common.settings.end(), settings.begin(), settings.end());
    };
    const auto parse_folder = [](const std::string &path) {
        std::error_code failed;
        if (!std::filesystem::is_directory(path, failed)) {
            throw InputError("there is no folder '{}'{}", path, failed ? fmt::format(" ({})", failed.message()) : "");
        }
        return std::filesystem::path(path);
    };
    const auto parse_profile = [](const std::string &name) {
        if (name != "core" && name != "es") {
            throw InputError("expected core or es, got '{}'", name);
        }
        return name == "es" ? Profile::es : Profile::core;
    };
    command.option_defaults()->group("Common options");
    command
        .add_option_function<std::vector<std::string>>(
            "--set", add_settings, "Change the scene before use, e.g. --set lights[0].diffuse=0.5; repeatable")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    add_parsed(command, "--shaders", "DIR", common.shaders, parse_folder, "Read the shader parts from this folder");
    add_parsed(command, "--assets", "DIR", common.assets, parse_folder,
               "Read scenes, lessons, textures and models from this folder");
    add_choice(command, "--backend", {"egl", "glfw"}, common.backend, "How to reach OpenGL without a window [egl]");
    add_parsed(command, "--profile", "core|es", common.profile, parse_profile,
               fmt::format("OpenGL 3.3 core, or ES 3.0 as browsers have it [{}]",
                           default_profile == Profile::es ? "es" : "core"));
    command.add_flag("-v", common.verbose, "Report the renderer, programs built and times on standard error");
}

} // namespace sandbox
