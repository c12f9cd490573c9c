#include "ui/widgets/fonts.h"

#include "image/system_font.h"

#include <imgui.h>
#include <optional>
#include <utility>

namespace sandbox {

namespace {

constexpr float chinese_square = 0.875F; // of the line's height

void add_font(const std::optional<FontFile> &file, float pixels) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    if (!file) {
        ImFontConfig config;
        config.SizePixels = pixels;
        atlas.AddFontDefault(&config);
        return;
    }
    // Latin, Greek, Cyrillic (names of files may hold them), punctuation, arrows, signs.
    static const ImWchar glyphs[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x04FF, 0x2010, 0x2027,
                                     0x2030, 0x203A, 0x2190, 0x2199, 0x2212, 0x2212, 0};
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    atlas.AddFontFromFileTTF(file->path.c_str(), pixels, &config, glyphs);
}

/// Into the font that was added last, `pixels` high, as wide and high as Latin type beside it looks. `ranges` must live
/// until the atlas is built.
void merge_chinese(float pixels, const ImVector<ImWchar> &ranges) {
    ImFontConfig config;
    config.MergeMode = true;
    config.FontNo = chinese_font()->index;
    config.OversampleH = 1;
    config.PixelSnapH = true;
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    atlas.AddFontFromFileTTF(chinese_font()->path.c_str(), pixels, &config, ranges.Data);
    // Negative: of a character's square, not of the line, which Chinese fonts have up to half as high again.
    atlas.ConfigData.back().SizePixels = -pixels * chinese_square;
}

} // namespace

void load_fonts(float scale, const std::set<char32_t> &chinese) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    ImVector<ImWchar> ranges;
    ImFontGlyphRangesBuilder builder;
    for (const char32_t character : chinese) {
        if (character <= IM_UNICODE_CODEPOINT_MAX) {
            builder.AddChar(static_cast<ImWchar>(character));
        }
    }
    builder.BuildRanges(&ranges);
    const bool merges = !chinese.empty() && chinese_font();
    const auto add = [&](const std::optional<FontFile> &file, float pixels) {
        add_font(file, pixels);
        if (merges) {
            merge_chinese(pixels, ranges);
        }
    };
    const auto text = find_font({{"NotoSans-Regular.ttf"},
                                 {"DejaVuSans.ttf"},
                                 {"LiberationSans-Regular.ttf"},
                                 {"FreeSans.ttf"},
                                 {"Ubuntu-R.ttf"}});
    add(text, 16 * scale);
    add(find_font({{"NotoSansMono-Regular.ttf"},
                   {"DejaVuSansMono.ttf"},
                   {"LiberationMono-Regular.ttf"},
                   {"FreeMono.ttf"},
                   {"UbuntuMono-R.ttf"}}),
        15 * scale);
    add(text, 24 * scale);
    atlas.Build(); // while `ranges` lives
}

ImFont *code_font() { return ImGui::GetIO().Fonts->Fonts[1]; }
ImFont *lecture_font() { return ImGui::GetIO().Fonts->Fonts[2]; }

} // namespace sandbox
