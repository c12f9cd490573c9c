#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A script works the window in place of a person: one action a line, a word and what it acts on.
namespace sandbox {

struct ScriptLine {
    int number = 0;                 ///< from 1
    std::vector<std::string> words; ///< at least one; "two words" in double quotes are one
};

/// The lines that hold an action: blank ones and comments (#) are left out. Throws InputError "NAME:LINE: ..." for a
/// quote without its end.
std::vector<ScriptLine> script_lines(std::string_view name, std::string_view text);

/// A key and the modifiers held with it, as GLFW names them.
struct KeyChord {
    int key = 0, mods = 0;
};
/// "F12", "Ctrl+Shift+Z", "?": as the list of keys writes them. Throws InputError.
KeyChord parse_key(std::string_view text);

} // namespace sandbox
