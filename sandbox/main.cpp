#include "commands/commands.h"
#include "commands/interrupt.h"
#include "image/plain_text.h"
#include "image/thread.h"
#include "render/gl_program.h"
#include "scene/scene_file.h"
#include "scene/suggest.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <span>
#include <sstream>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

using namespace sandbox;

constexpr int bad_usage = 2;
constexpr int machine_lacks = 3;

/// Where no command was chosen, the first word must be a scene. A name that is none may be a mistyped command.
void check_first_word(const CLI::App &app, const CommonOptions &common) {
    const std::vector<std::string> words = app.get_option("SCENE")->results();
    const std::filesystem::path word(words.empty() ? "" : words.front());
    const std::vector<std::string> scenes = builtin_scenes(scene_assets(common));
    if (words.empty() || word.has_parent_path() || word.has_extension() ||
        std::ranges::find(scenes, word.string()) != scenes.end()) {
        return;
    }
    std::vector<std::string_view> known;
    for (const CLI::App *command : app.get_subcommands({})) {
        known.push_back(command->get_name());
    }
    known.insert(known.end(), scenes.begin(), scenes.end());
    const std::string_view nearest = nearest_word(word.string(), known);
    throw InputError("'{}' is neither a command nor a built-in scene{}", word.string(),
                     nearest.empty() ? " (see: shading-sandbox --help, shading-sandbox list)"
                                     : fmt::format("; did you mean \"{}\"?", nearest));
}

/// Prints --help or --version, or reports what is wrong with the command line; CLI11's exit codes become ours.
int end_of_parsing(const CLI::App &app, const CommonOptions &common, const CLI::ParseError &end) {
    std::ostringstream out, err;
    if (app.exit(end, out, err) == 0) {
        print(out.str());
        return 0;
    }
    const auto chosen = app.get_subcommands();
    if (chosen.empty()) {
        check_first_word(app, common);
    }
    note(fmt::format("{} (see: shading-sandbox {}--help)", end.what(),
                     chosen.empty() ? "" : chosen[0]->get_name() + " "));
    return bad_usage;
}

/// Paths go into files that are UTF-8: one that is none is refused before any work, not when the work is written.
void check_words(std::span<char *const> words) {
    for (const std::string_view word : words) {
        if (!is_utf8(word)) {
            throw InputError("'{}': expected UTF-8 text; rename the file or folder", plain_text(word));
        }
    }
}

int parse_and_run(int argc, char **argv) {
    check_words(std::span(argv, static_cast<std::size_t>(argc)).subspan(argc > 0 ? 1 : 0)); // without its own name
    CLI::App app("Draws one scene with several shading techniques, compares the pictures and measures them.",
                 "shading-sandbox");
    app.set_version_flag("--version", "shading-sandbox " SANDBOX_VERSION, "Print the version and exit");
    app.require_subcommand(0, 1);
    CommonOptions common;
    Run run;
    add_commands(app, common, run);
    add_common_options(app, common);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &end) {
        app.footer(help_footer());
        return end_of_parsing(app, common, end);
    }
    if (app.get_subcommands().empty()) {
        check_first_word(app, common);
    } else if (const CLI::Option *scene = app.get_option("SCENE"); scene->count() > 0) {
        throw InputError("'{}' is not a command (the command comes first)", scene->results().front());
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

/// At the end of a frame a software renderer frees what it took: glibc would give those pages back to the system, and
/// fetch them again for the next.
void keep_pages_between_frames() {
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 8 << 20);
#endif
}

int run_program(int argc, char **argv) {
    keep_pages_between_frames();
    try {
        return parse_and_run(argc, argv);
    } catch (const sandbox::InputError &error) {
        sandbox::note(error.what());
        return bad_usage;
    } catch (const std::filesystem::filesystem_error &error) { // the current folder is gone, say
        const std::string path = error.path1().empty() ? "the current folder" : error.path1().string();
        sandbox::note(fmt::format("{}: {}", path, error.code().message()));
        return bad_usage;
    } catch (const std::bad_alloc &) {
        sandbox::note("not enough memory; try a smaller --size, smaller textures or fewer triangles");
        return machine_lacks;
    } catch (const std::exception &error) {
        sandbox::note(error.what());
        return machine_lacks;
    }
}

} // namespace

#ifndef __EMSCRIPTEN__
int main(int argc, char **argv) { return run_program(argc, argv); }
#else
extern "C" void page_ended(int code); // sandbox/page/browser.js

/// As a thread, so that what takes long lets the page live. The words live as long as the page.
int main(int argc, char **argv) {
    static const sandbox::Thread program(
        [argc, argv](const std::stop_token &) { page_ended(run_program(argc, argv)); });
    return 0;
}
#endif
