#include "ui/text_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <map>
#include <utility>

namespace sandbox {

namespace {

constexpr float tolerance = 1.5F;      // pixels: hinting moves glyphs by one
constexpr float least_overlap_y = 3;   // lines may touch
constexpr std::size_t told_before = 8; // characters, so that a person finds the place

struct Glyph {
    ImWchar character = 0;
    ImVec2 low, high;
};

using Corner = std::pair<float, float>;
using Glyphs = std::map<Corner, const ImFontGlyph *>;

/// All glyphs of the fonts by the upper left corner of their place in the texture.
Glyphs glyphs_by_place() {
    Glyphs all;
    for (const ImFont *font : ImGui::GetIO().Fonts->Fonts) {
        for (const ImFontGlyph &glyph : font->Glyphs) {
            if (glyph.Visible != 0) {
                all.emplace(Corner(glyph.U0, glyph.V0), &glyph);
            }
        }
    }
    return all;
}

/// The glyphs of a window, in the order in which they are drawn, and where its texts are cut off.
struct WindowText {
    std::vector<Glyph> glyphs;
    std::vector<std::size_t> cut;
};

WindowText text_of(const ImDrawList &list, const Glyphs &known) {
    WindowText text;
    for (const ImDrawCmd &command : list.CmdBuffer) {
        if (command.TextureId != ImGui::GetIO().Fonts->TexID) {
            continue;
        }
        for (unsigned i = 0; i + 5 < command.ElemCount;) {
            const auto vertex = [&](unsigned k) -> const ImDrawVert & {
                return list.VtxBuffer[static_cast<int>(command.VtxOffset) +
                                      list.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)]];
            };
            const ImDrawVert &low = vertex(0), &high = vertex(2);
            const auto found = known.find({low.uv.x, low.uv.y});
            if (found == known.end() || found->second->U1 < high.uv.x || found->second->V1 != high.uv.y) {
                i += 3;
                continue;
            }
            i += 6;
            const bool trimmed = found->second->U1 > high.uv.x;
            const bool over = low.pos.x < command.ClipRect.x - tolerance || high.pos.x > command.ClipRect.z + tolerance;
            const bool seen = high.pos.y > command.ClipRect.y && low.pos.y < command.ClipRect.w &&
                              command.ClipRect.z > command.ClipRect.x;
            if (!seen) {
                continue;
            }
            const ImVec2 seen_low(low.pos.x, std::max(low.pos.y, command.ClipRect.y)),
                seen_high(high.pos.x, std::min(high.pos.y, command.ClipRect.w));
            text.glyphs.push_back({static_cast<ImWchar>(found->second->Codepoint), seen_low, seen_high});
            if (trimmed || over) {
                text.cut.push_back(text.glyphs.size() - 1);
            }
        }
    }
    return text;
}

bool scrolls_sideways(const ImDrawList &list) {
    return std::ranges::any_of(GImGui->Windows, [&](const ImGuiWindow *window) {
        return window->DrawList == &list && window->ScrollMax.x > 0;
    });
}

/// What stands before and at a glyph.
std::string words_at(const std::vector<Glyph> &glyphs, std::size_t at) {
    std::string words;
    for (std::size_t i = at + 1 < told_before ? 0 : at + 1 - told_before; i <= at; ++i) {
        std::array<char, 5> utf8{};
        words += ImTextCharToUtf8(utf8.data(), glyphs[i].character);
    }
    return fmt::format("'{}' at {:.0f}, {:.0f}", words, glyphs[at].low.x, glyphs[at].low.y);
}

/// A text and its shadow are one.
bool overlap(const Glyph &a, const Glyph &b) {
    const bool shadow = a.character == b.character && std::abs(a.low.x - b.low.x) <= tolerance;
    return !shadow && std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x) > tolerance &&
           std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y) > least_overlap_y;
}

} // namespace

std::vector<std::string> text_faults() {
    std::vector<std::string> faults;
    const Glyphs known = glyphs_by_place();
    const ImDrawData &data = *ImGui::GetDrawData();
    for (int list = 0; list < data.CmdListsCount; ++list) {
        const WindowText text = text_of(*data.CmdLists[list], known);
        for (const std::size_t cut : scrolls_sideways(*data.CmdLists[list]) ? std::vector<std::size_t>{} : text.cut) {
            faults.push_back("cut off: " + words_at(text.glyphs, cut));
        }
        std::vector<std::size_t> order(text.glyphs.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::ranges::sort(order, {}, [&](std::size_t i) { return text.glyphs[i].low.x; });
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Glyph &glyph = text.glyphs[order[i]];
            for (std::size_t k = i + 1; k < order.size() && text.glyphs[order[k]].low.x < glyph.high.x; ++k) {
                if (overlap(glyph, text.glyphs[order[k]])) {
                    faults.push_back(fmt::format("{} lies over {}", words_at(text.glyphs, order[k]),
                                                 words_at(text.glyphs, order[i])));
                }
            }
        }
    }
    return faults;
}

} // namespace sandbox
