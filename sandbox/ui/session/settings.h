#pragma once

#include "ui/session/session.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// What the window remembers from one time to the next.
struct Settings {
    bool dark = true;
    bool panels = true;
    double scale = 1;       ///< of text and controls, [0.6, 3]
    std::string language;   ///< of languages; empty: the system's
    Size window{1280, 720}; ///< [480, 16384] x [320, 16384]
    PanelSizes panel_sizes;
    std::vector<std::string> recent; ///< absolute paths of files, the last one first; at most most_recent
    LessonProgress lessons;
    SolvedExercises exercises; ///< solved ones
    bool operator==(const Settings &) const = default;
};
constexpr std::size_t most_recent = 10;
constexpr Size least_window{480, 320};

/// shading-sandbox/settings.json in the platform's configuration folder ($XDG_CONFIG_HOME, else ~/.config); empty where
/// there is none.
std::filesystem::path settings_file();

/// The settings in `file`; defaults where it is absent. A damaged one is renamed FILE.damaged, and `message` says so;
/// numbers out of range become the nearest in range.
Settings read_settings(const std::filesystem::path &file, std::string &message);
/// The same of a file's text; `name` is used in messages. Throws for a damaged one.
Settings parse_settings(std::string_view text, std::string_view name);
/// As write_settings() writes them.
std::string settings_text(const Settings &settings);
/// Makes the folder if need be. Throws InputError.
void write_settings(const std::filesystem::path &file, const Settings &settings);

/// Of languages, as LC_ALL, else LC_MESSAGES, else LANG has it; English where they name none of them.
std::string system_language();

/// Puts `path` in front of the recent files.
void add_recent(Settings &settings, const std::filesystem::path &path);

} // namespace sandbox
