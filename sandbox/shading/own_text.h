#pragma once

#include "shading/own_tokens.h"

#include <set>
#include <string>
#include <vector>

/// Own shading: GLSL ES 3.00 text that lights the scene in place of the program's own equation. It is not trusted: what
/// is drawn is not the text itself but its tokens, checked, with a counter in the condition of every loop.
namespace sandbox {

/// What is accepted beside the limits of own_tokens.h. With them, the work of one pixel is bounded.
constexpr int most_own_turns = 4096;           ///< of all loops of one point together
constexpr int deepest_own_nesting = 64;        ///< of brackets of all kinds
constexpr std::size_t longest_statement = 512; ///< tokens
constexpr int most_own_elses = 256;
constexpr std::size_t most_inlined_tokens = 16384; ///< of a function with all that it calls
constexpr std::size_t most_inlined_loops = 8;      ///< likewise: Mesa takes half a minute to compile 16 in a row
constexpr int longest_own_array = 256;
constexpr int most_array_numbers = 1024; ///< in all arrays together: llvmpipe takes seconds for twice as many

struct OwnText {
    std::string file;
    std::string text;               ///< as it was given
    std::vector<std::string> lines; ///< what is compiled, a line for each of the file
    std::set<std::string, std::less<>> words;
    bool reads_P = false; ///< lighting() names its first parameter; the second; the third
    bool reads_N = false;
    bool reads_eye = false;
    bool position = false; ///< defines vec3 position(vec3 p): from model space to world space
    bool normal = false;   ///< defines vec3 normal(vec3 n), likewise
    bool base = false;     ///< calls base()
    bool loops = false;
    bool makes_lights = false; ///< calls Light(...), which takes every field

    [[nodiscard]] bool names(std::string_view word) const { return words.contains(word); }
};

/// Throws InputError "file:line: ..." for what is not accepted.
OwnText read_own_text(std::string file, std::string text);

} // namespace sandbox
