#include "image/system_font.h"

#include "image/file_io.h"
#ifdef __EMSCRIPTEN__
#include "image/page_glyph.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <imstb_truetype.h> // as Dear ImGui has it

namespace sandbox {

namespace {

namespace fs = std::filesystem;

constexpr double baseline = 0.86; // of the line's height, from its top

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders;
    if (const char *data = std::getenv("XDG_DATA_HOME")) {
        folders.push_back(fs::path(data) / "fonts");
    }
    if (const char *home = std::getenv("HOME")) {
        folders.push_back(fs::path(home) / ".local/share/fonts");
        folders.push_back(fs::path(home) / ".fonts");
    }
    folders.insert(folders.end(), {"/usr/local/share/fonts", "/usr/share/fonts"});
    return folders;
}

/// Skips folders that cannot be read.
std::vector<fs::path> font_files() {
    std::vector<fs::path> files;
    for (const fs::path &folder : font_folders()) {
        std::error_code error;
        fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
        while (!error && at != fs::recursive_directory_iterator()) {
            const std::string ending = at->path().extension().string();
            if (ending == ".ttf" || ending == ".ttc" || ending == ".otf") {
                files.push_back(at->path());
            }
            at.increment(error);
        }
    }
    return files;
}

/// Of a font's file, in memory.
struct Outlines {
    std::string bytes;
    stbtt_fontinfo info{};
};

/// Null: there is none.
std::unique_ptr<const Outlines> read_outlines(const std::optional<FontFile> &file) {
    if (!file) {
        return nullptr;
    }
    auto font = std::make_unique<Outlines>();
    font->bytes = read_file(file->path);
    const auto *data = reinterpret_cast<const unsigned char *>(font->bytes.data());
    const int offset = stbtt_GetFontOffsetForIndex(data, file->index);
    return offset >= 0 && stbtt_InitFont(&font->info, data, offset) != 0 ? std::move(font) : nullptr;
}

const Outlines *outlines() {
    static const std::unique_ptr<const Outlines> loaded = read_outlines(chinese_font());
    return loaded.get();
}

/// 0: there is none.
int glyph_of(char32_t character, const Outlines *font = outlines()) {
    return font == nullptr ? 0 : stbtt_FindGlyphIndex(&font->info, static_cast<int>(character));
}

float scale_for(double height) {
    return stbtt_ScaleForMappingEmToPixels(&outlines()->info, static_cast<float>(height));
}

} // namespace

std::optional<FontFile> find_font(std::initializer_list<FontFile> names) {
    const std::vector<fs::path> files = font_files();
    for (const FontFile &wanted : names) {
        for (const fs::path &file : files) {
            std::error_code error;
            if (file.filename() == wanted.path && fs::file_size(file, error) > 0 && !error) {
                return FontFile{file, wanted.index};
            }
        }
    }
    return std::nullopt;
}

const std::optional<FontFile> &chinese_font() {
    static const std::optional<FontFile> found = find_font({{"NotoSansCJK-Regular.ttc", 2},
                                                            {"NotoSansCJKsc-Regular.otf"},
                                                            {"NotoSansSC-Regular.otf"},
                                                            {"NotoSansSC-Regular.ttf"},
                                                            {"SourceHanSansSC-Regular.otf"},
                                                            {"wqy-microhei.ttc"},
                                                            {"wqy-zenhei.ttc"},
                                                            {"DroidSansFallbackFull.ttf"},
                                                            {"DroidSansFallback.ttf"}});
    return found;
}

char32_t take_character(std::string_view &text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
    char32_t character = length == 1 ? first : length == 0 ? 0xFFFD : first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (i >= text.size() || byte(i) >> 6 != 2) {
            text.remove_prefix(i);
            return 0xFFFD;
        }
        character = character << 6 | (byte(i) & 0x3FU);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
    return character;
}

bool in_text_font(char32_t character) {
#ifdef __EMSCRIPTEN__ // a part of the font, without most of the ranges
    static const std::unique_ptr<const Outlines> text = read_outlines(find_font({{"DejaVuSans.ttf"}}));
    return glyph_of(character, text.get()) != 0;
#else
    return std::ranges::any_of(
        text_ranges, [&](const auto &range) { return character >= range.front() && character <= range.back(); });
#endif
}

std::optional<GlyphPicture> browser_glyph([[maybe_unused]] char32_t character, [[maybe_unused]] double height) {
#ifdef __EMSCRIPTEN__
    if (glyph_of(character) == 0) {
        return page_glyph(character, height);
    }
#endif
    return std::nullopt;
}

std::optional<double> font_advance(char32_t character, double height) {
    const int glyph = glyph_of(character);
    if (glyph == 0) {
#ifdef __EMSCRIPTEN__
        return page_glyph_advance(character, height);
#else
        return std::nullopt;
#endif
    }
    int advance = 0;
    stbtt_GetGlyphHMetrics(&outlines()->info, glyph, &advance, nullptr);
    return static_cast<double>(static_cast<float>(advance) * scale_for(height));
}

std::optional<GlyphPicture> font_glyph(char32_t character, double height) {
    const int glyph = glyph_of(character);
    if (glyph == 0) {
        std::optional<GlyphPicture> drawn = browser_glyph(character, height);
        if (drawn) {
            drawn->y += std::round(baseline * height);
        }
        return drawn;
    }
    const float scale = scale_for(height);
    GlyphPicture picture;
    int left = 0, top = 0, right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBox(&outlines()->info, glyph, scale, scale, &left, &top, &right, &bottom);
    picture.width = right - left;
    picture.height = bottom - top;
    picture.x = left;
    picture.y = std::round(baseline * height) + top;
    picture.cover.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    if (!picture.cover.empty()) {
        stbtt_MakeGlyphBitmap(&outlines()->info, picture.cover.data(), picture.width, picture.height, picture.width,
                              scale, scale, glyph);
    }
    return picture;
}

} // namespace sandbox
