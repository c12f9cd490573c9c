#include "ui/widgets/fonts.h"

#include "image/system_font.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <optional>
#include <utility>
#include <vector>

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
    static const std::vector<ImWchar> glyphs = [] {
        std::vector<ImWchar> pairs;
        for (const auto &range : text_ranges) {
            pairs.insert(pairs.end(), range.begin(), range.end());
        }
        pairs.push_back(0);
        return pairs;
    }();
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    atlas.AddFontFromFileTTF(file->path.c_str(), pixels, &config, glyphs.data());
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

struct DrawnGlyph {
    int rect; ///< of the atlas
    GlyphPicture picture;
};

/// Room in the atlas for what no font has, in the font that was added last, as large as Chinese is.
void reserve_drawn(std::vector<DrawnGlyph> &drawn, float pixels, const std::set<char32_t> &rare) {
    constexpr float baseline = 0.8F; // of the line's height, as the text fonts have it
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    const double em = static_cast<double>(pixels * chinese_square);
    for (const char32_t character : rare) {
        auto picture = character > IM_UNICODE_CODEPOINT_MAX ? std::nullopt : browser_glyph(character, em);
        if (picture) {
            const ImVec2 corner{static_cast<float>(picture->x),
                                std::round(baseline * pixels) + static_cast<float>(picture->y)};
            const int rect =
                atlas.AddCustomRectFontGlyph(atlas.Fonts.back(), static_cast<ImWchar>(character), picture->width,
                                             picture->height, static_cast<float>(*font_advance(character, em)), corner);
            drawn.push_back({rect, std::move(*picture)});
        }
    }
}

/// After the atlas has been built.
void fill_drawn(const std::vector<DrawnGlyph> &drawn) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    for (const DrawnGlyph &glyph : drawn) {
        const ImFontAtlasCustomRect &rect = *atlas.GetCustomRectByIndex(glyph.rect);
        for (int y = 0; y < glyph.picture.height; ++y) {
            const auto row = glyph.picture.cover.begin() + y * glyph.picture.width;
            std::copy_n(row, glyph.picture.width, atlas.TexPixelsAlpha8 + (rect.Y + y) * atlas.TexWidth + rect.X);
        }
    }
}

} // namespace

void load_fonts(float scale, const std::set<char32_t> &rare) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    ImVector<ImWchar> ranges;
    ImFontGlyphRangesBuilder builder;
    for (const char32_t character : rare) {
        if (character <= IM_UNICODE_CODEPOINT_MAX) {
            builder.AddChar(static_cast<ImWchar>(character));
        }
    }
    builder.BuildRanges(&ranges);
    const bool merges = !rare.empty() && chinese_font();
    std::vector<DrawnGlyph> drawn;
    const auto add = [&](const std::optional<FontFile> &file, float pixels) {
        add_font(file, pixels);
        if (merges) {
            merge_chinese(pixels, ranges);
        }
        reserve_drawn(drawn, pixels, rare);
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
    fill_drawn(drawn);
}

ImFont *code_font() { return ImGui::GetIO().Fonts->Fonts[1]; }
ImFont *lecture_font() { return ImGui::GetIO().Fonts->Fonts[2]; }

} // namespace sandbox
