#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// A piece of own shading, as it is after its #defines.
struct OwnToken {
    enum class Kind { word, number, symbol };
    Kind kind;
    std::string text;
    int line;       ///< of the file, from 1
    int column;     ///< from 0
    bool set_apart; ///< a space or a comment stood before it

    [[nodiscard]] bool is(std::string_view other) const { return text == other; }
    [[nodiscard]] bool is_word() const { return kind == Kind::word; }
};

constexpr std::size_t most_own_bytes = 65536;
constexpr std::size_t most_own_tokens = 8192; ///< and as many expansions of #defines

/// Throws InputError "file:line: message".
[[noreturn]] void refuse_own(const std::string &file, int line, const std::string &message);

/// The tokens of a file. Comments are dropped and `#define NAME VALUE` is carried out here, so that no directive and no
/// comment reaches a driver. Throws InputError for any other directive, for a character that GLSL has not, and for a
/// text that is too long.
std::vector<OwnToken> own_tokens(std::string_view text, const std::string &file);

} // namespace sandbox
