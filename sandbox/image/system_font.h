#pragma once

#include <array>
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

/// What the fonts of text and code are asked for, first and last: Latin, Greek, Cyrillic (names of files may hold
/// them), punctuation, arrows, signs.
constexpr std::array<std::array<char32_t, 2>, 7> text_ranges{{{0x0020, 0x024F},
                                                              {0x0370, 0x03FF},
                                                              {0x0400, 0x04FF},
                                                              {0x2010, 0x2027},
                                                              {0x2030, 0x203A},
                                                              {0x2190, 0x2199},
                                                              {0x2212, 0x2212}}};
/// Whether they are asked for `character`; in a page, whether they have it.
bool in_text_font(char32_t character);

/// A glyph, rendered: how far (x, y) lies from the pen, y down from the top of the line.
struct GlyphPicture {
    int width = 0, height = 0;
    double x = 0, y = 0;
    std::vector<unsigned char> cover; ///< rows from the top, 255: whole
};
/// Of chinese_font(), else in a page as the browser draws it. Ideographs are as wide as the line is high (in pixels).
/// Null: neither has the character.
std::optional<double> font_advance(char32_t character, double height);
std::optional<GlyphPicture> font_glyph(char32_t character, double height);
/// What chinese_font() lacks, as the browser draws it; y is from the baseline. Null outside a
/// page.
std::optional<GlyphPicture> browser_glyph(char32_t character, double height);

} // namespace sandbox
