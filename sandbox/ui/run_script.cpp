#include "ui/run_script.h"

#include "image/error.h"
#include "image/image_file.h"
#include "image/plain_text.h"
#include "ui/script_player.h"

#include <cstdio>
#include <fmt/format.h>

namespace sandbox {

namespace {

/// All lines are checked before the first is run.
std::vector<ScriptLine> checked_lines(const std::string &name) {
    std::vector<ScriptLine> lines = script_lines(name, read_file(name));
    for (const ScriptLine &line : lines) {
        const ScriptAction *action = find_action(line.words.front());
        if (action == nullptr) {
            throw InputError("{}:{}: '{}' is no action; there are:\n{}", name, line.number, line.words.front(),
                             script_help());
        }
        if (const std::size_t words = line.words.size() - 1; words < action->fewest || words > action->most) {
            throw InputError("{}:{}: expected {} {}", name, line.number, action->name, action->takes);
        }
    }
    return lines;
}

} // namespace

std::string script_help() {
    std::string text;
    for (const ScriptAction &action : script_actions()) {
        text += fmt::format("  {:<34} {}\n", fmt::format("{} {}", action.name, action.takes), action.help);
    }
    return text;
}

int run_script(const std::filesystem::path &file, const WindowOptions &options) {
    const std::string name = file.string();
    const std::vector<ScriptLine> lines = checked_lines(name);
    ScriptedHost host(options.size.value_or(options.settings.window), options.profile);
    Window window(options, host);
    ScriptPlayer player(window, host);
    for (const ScriptLine &line : lines) {
        try {
            player.play(line);
        } catch (const ExpectationFailed &failed) {
            fmt::print(stderr, "{}:{}: {}\n", plain_text(name), line.number, plain_lines(failed.what()));
            return 1;
        } catch (const InputError &error) {
            throw InputError("{}:{}: {}", name, line.number, error.what());
        }
        if (window.quit_asked()) {
            break;
        }
    }
    return 0;
}

} // namespace sandbox
