#include "commands/commands.h"
#include "commands/own_flags.h"
#include "teach/files/taught_file.h"
#include "teach/lesson_read.h"
#include "teach/marking/exercise_read.h"
#include "ui/run_script.h"
#include "ui/run_window.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sandbox {
namespace {

struct ViewFlags {
    std::string scene = "studio"; ///< or a lesson's file
    std::string lesson;           ///< a built-in name or a path; empty: none
    std::string exercise;         ///< likewise
    OwnFlags own;
    std::string left, right; ///< empty: a sidecar's, the scene's or the window's own
    std::string script;      ///< a file; empty: a person works the window
    std::optional<Size> size;
    std::filesystem::path settings; ///< empty: a window's own, a script's none
    bool no_times = false;
    std::string language; ///< empty: a window's as its settings say, a script's English
};

/// A window runs for hours and makes pictures on several threads: what is freed goes back to the system. Left alone,
/// glibc raises its threshold up to 32 MiB, and pictures tear holes into the heaps of threads that have ended.
void keep_no_freed_pictures() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 256 * 1024);
    mallopt(M_ARENA_MAX, 2);
#endif
}

int run_view(const ViewFlags &flags, const CommonOptions &common) {
    keep_no_freed_pictures();
    WindowOptions options;
    options.assets = scene_assets(common);
    options.shaders = shader_assets(common);
    const bool lesson = taught_file(flags.scene) == TaughtFile::lesson;
    const std::string scene = lesson ? ViewFlags().scene : flags.scene;
    options.file = open_file(scene, options.assets, open_scene(common, scene)); // with every --set
    if (lesson || !flags.lesson.empty()) {
        const std::string id = lesson ? flags.scene : flags.lesson;
        options.lesson = taught_file(id) == TaughtFile::lesson ? std::filesystem::absolute(id).string() : id;
        open_lesson(options.lesson, options.assets, words_in(languages.front(), options.assets)); // throws if bad
    }
    if (!flags.exercise.empty()) {
        options.exercise = taught_file(flags.exercise) == TaughtFile::exercise
                               ? std::filesystem::absolute(flags.exercise).string()
                               : flags.exercise;
        open_exercise(options.exercise, options.assets, words_in(languages.front(), options.assets)); // throws if bad
    }
    OwnTechniques techniques(flags.own);
    if (!flags.left.empty()) {
        options.file.left = techniques.left(flags.left);
        options.file.textbook_left = false;
    }
    if (!flags.right.empty()) {
        options.file.right = techniques.right(flags.right);
    }
    techniques.require_all_used();
    options.profile = common.profile;
    options.size = flags.size;
    options.run_times = !flags.no_times;
    options.settings_file = !flags.settings.empty() ? flags.settings : flags.script.empty() ? settings_file() : "";
    options.settings = read_settings(options.settings_file, options.message);
    options.language = flags.language.empty() && !flags.script.empty() ? languages.front() : flags.language;
    if (!flags.script.empty()) {
        return run_script(flags.script, options);
    }
    return run_window(options);
}

} // namespace

void add_window(CLI::App &app, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<ViewFlags>();
    add_value(app, "SCENE", "", flags->scene, "Without a command: the scene to open in the window");
    run = [flags, &common] { return run_view(*flags, common); };
}

void add_view_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<ViewFlags>();
    add_value(command, "SCENE", "", flags->scene, "Built-in name, or path of a .json, sidecar, lesson or .obj file")
        ->capture_default_str();
    add_value(command, "--left", "T", flags->left,
              "Technique of the left view, A [the scene's, else per-vertex/blinn-phong]");
    add_value(command, "--right", "T", flags->right,
              "Technique of the right view, B [the scene's, else per-pixel/blinn-phong]");
    add_own_files(command, flags->own, true);
    add_value(command, "--lesson", "NAME", flags->lesson,
              "Lesson to show: a built-in name (see: list) or a .json file");
    add_value(command, "--exercise", "NAME", flags->exercise,
              "Exercise to show: a built-in name (see: list) or a .json file");
    add_value(command, "--script", "FILE", flags->script,
              "Works the window by the actions in FILE, without a display; they are listed below");
    add_parsed(command, "--size", "WxH", flags->size, parse_size,
               "Size of the window at first [as last time, or 1280x720]");
    add_value(command, "--settings", "FILE", flags->settings,
              "Keeps size, theme and recent files there [in the configuration folder; a script keeps none]");
    add_language(command, flags->language,
                 "Language of the window [as its menu was set, else the system's; of a script en]");
    command.add_flag("--no-times", flags->no_times, "Hides run times, so that pictures of the window repeat");
    command.footer("A script has an action on each line, # begins a comment:\n" + script_help());
    run_when_chosen(command, common, run, flags, run_view);
}

} // namespace sandbox
