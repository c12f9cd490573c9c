#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

/// Fonts that are installed on this machine.
namespace sandbox {

struct FontFile {
    std::filesystem::path path;
    int index = 0; ///< within a collection (.ttc)
};
/// The first of `names` that is below the usual folders.
std::optional<FontFile> find_font(std::initializer_list<FontFile> names);
/// One with Simplified Chinese: Noto Sans CJK, WenQuanYi and others. Nothing where none is installed. Looked for once.
const std::optional<FontFile> &chinese_font();

/// Characters from here on are Chinese, Japanese or Korean: none of the other fonts has them.
constexpr char32_t first_chinese = 0x2E80;
/// The next character of UTF-8, which loses its bytes; U+FFFD for a byte that is none. `text` must not be empty.
char32_t take_character(std::string_view &text);

/// A glyph of chinese_font(), rendered: how far (x, y) lies from the pen, y down from the top of the line.
struct GlyphPicture {
    int width = 0, height = 0;
    double x = 0, y = 0;
    std::vector<unsigned char> cover; ///< rows from the top, 255: whole
};
/// Ideographs are as wide as the line is high (in pixels). Null: there is no font, or it lacks the character.
std::optional<double> chinese_advance(char32_t character, double height);
std::optional<GlyphPicture> chinese_glyph(char32_t character, double height);

} // namespace sandbox
