#include "ui/views/view_captions.h"

#include "capture/masks.h"
#include "capture/picture.h"
#include "measure/report/text.h"
#include "ui/session/fault_names.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

/// The first of `texts`, the longest first, that fits into `width`.
std::string longest_that_fits(const std::vector<std::string> &texts, float width) {
    const auto fits = [&](const std::string &text) { return ImGui::CalcTextSize(text.c_str()).x <= width; };
    const auto found = std::ranges::find_if(texts, fits);
    return found == texts.end() ? texts.back() : *found;
}

/// Where the last word begins, with the space before it, or the last character of a text without spaces.
std::size_t last_break(const std::string &text) {
    std::size_t character = text.size() - 1;
    while (character > 0 && (static_cast<unsigned char>(text[character]) & 0xC0U) == 0x80U) {
        --character;
    }
    const std::size_t space = text.find_last_of(' ');
    const bool is_word = static_cast<unsigned char>(text[character]) < 0x80;
    return is_word && space != std::string::npos ? space : is_word && space == std::string::npos ? 0 : character;
}

/// "    attenuation per vertex, power: stable": what differs from the defaults, faults under people's names.
std::string deviations(const Words &words, const Technique &technique) {
    std::string names;
    for (const TechniqueKey &key : technique_keys()) {
        if (const int value = key.get(technique); value != 0 && key.kind != TechniqueKey::Kind::choice) {
            const std::string fault = fault_name(words, key, value);
            names += names.empty() ? "    " : words.text("list.comma");
            names += fault.empty() ? title_of(words, key, value) : fault;
        }
    }
    return names;
}

/// "A  per-vertex / phong", then what differs from the defaults.
std::string side_name(const Session &session, bool right) {
    const Technique &technique = session.technique(right);
    const bool textbook = !right && session.document.left_is_textbook();
    const Words &words = session.words;
    const std::string model = name_of(words, model_key, model_key.get(technique));
    const std::string text =
        textbook ? words.format("caption.textbook", model)
                 : fmt::format("{} / {}", name_of(words, frequency_key, frequency_key.get(technique)), model);
    return (right ? "B   " : "A   ") + text +
           mesh_factor_note(session.words, session.document.mesh_factors[right ? 1 : 0]) +
           (textbook ? "" : deviations(session.words, technique));
}

/// In what A and B differ.
std::string differing_keys(const Words &words, const Document &document) {
    std::vector<std::string> names;
    for (const TechniqueKey &key : technique_keys()) {
        if (key.get(document.left) != key.get(document.right)) {
            names.push_back(key.name == frequency_key.name ? words.text("header.frequency") : title_of(words, key));
        }
    }
    if (document.mesh_factors[0] != document.mesh_factors[1]) {
        names.push_back(words.text("header.mesh"));
    }
    return fmt::format("{}", fmt::join(names, words.text("list.comma")));
}

std::string header_text(const Session &session, const ViewPainter &painter) {
    const bool textbook = session.document.left_is_textbook();
    const std::string keys = textbook ? "" : differing_keys(session.words, session.document);
    const Findings *findings = painter.findings();
    const bool equal = findings != nullptr && findings->apart == 0.0;
    if (!textbook && keys.empty()) {
        return session.text("header.same");
    }
    const std::string text = textbook ? session.text("header.textbook") : session.text("header.differ", keys);
    return text + (equal                  ? session.text("header.equal")
                   : session.same_picture ? session.text("header.same_picture")
                                          : "");
}

std::string nonfinite_text(const Words &words, std::size_t pixels) {
    return pixels == 1 ? words.text("caption.nonfinite_one") : words.format("caption.nonfinite", pixels);
}

/// The longest first.
std::vector<std::string> error_texts(const Words &words, const SideFindings &side) {
    const Metrics &metrics = *side.metrics;
    if (metrics.nonfinite_pixels > 0) {
        return {nonfinite_text(words, metrics.nonfinite_pixels)};
    }
    if (std::isnan(metrics.norms.max_abs)) {
        return {words.format("caption.unknown_because", why_untrusted(words, metrics)), words.text("caption.unknown")};
    }
    const double most = metrics.norms.max_abs, rmse = metrics.norms.rmse;
    const int levels = metrics.max_levels.value_or(0);
    const bool seen = most >= 1.0 / 255; // a smaller error, too, may round to another level
    const std::string max = words.format(!seen         ? "caption.no_level"
                                         : levels == 1 ? "caption.one_level"
                                                       : "caption.levels",
                                         most, levels);
    const std::string short_max = seen ? fmt::format("{:.2g} ({})", most, levels) : fmt::format("{:.2g} (<1)", most);
    std::vector<std::string> texts{words.format("caption.error_whole", max, rmse),
                                   words.format("caption.error", max, rmse),
                                   words.format("caption.error", short_max, rmse),
                                   words.format("caption.figures", short_max, rmse), words.format("caption.max", most)};
    for (std::string &text : texts) {
        text += side.estimate ? words.text("caption.estimate") : "";
    }
    return texts;
}

std::string caption_milliseconds(double ms) { return fmt::format("{:.{}f}", ms, ms < 10 ? 1 : 0); }

std::vector<std::string> time_texts(const Words &words, const RunTime &time) {
    const std::string median = caption_milliseconds(time.median);
    const std::string low = caption_milliseconds(time.lower_quartile), high = caption_milliseconds(time.upper_quartile);
    return {words.format("caption.time_whole", median, time.samples.size(), low, high),
            words.format("caption.time", median, low, high), words.format("caption.time_brief", median, low, high),
            words.format("caption.ms", median)};
}

/// Of a side in half precision, whose run time would be that of an emulation.
std::vector<std::string> device_texts(const Words &words, const SideFindings &side) {
    if (!side.device) {
        return {words.text("caption.no_mediump"), words.text("caption.no_mediump_brief")};
    }
    return {words.format("caption.device", *side.device), words.format("caption.device_brief", *side.device),
            words.format("caption.device_short", *side.device)};
}

/// Under a picture, in two lines.
void draw_figures(Session &session, const ViewPainter &painter, const Rect &rect, bool right, bool align_right,
                  bool run_time) {
    const std::string name = right ? "B" : "A";
    const PaintedView &view = painter.view(right);
    if (view.texture == 0) {
        return;
    }
    const float line = ImGui::GetFrameHeight();
    const float room = rect.width() - ImGui::GetFontSize();
    const Findings *findings = painter.findings();
    const SideFindings *side = findings != nullptr ? &findings->sides[right ? 1 : 0] : nullptr;
    const ImVec4 plain = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    if (view.nonfinite > 0) { // counted with every picture, also while something is dragged
        draw_text_line(session, name + "/error", rect, rect.high.y, error_text(),
                       nonfinite_text(session.words, view.nonfinite), align_right);
    } else if (side != nullptr && side->metrics) {
        draw_text_line(session, name + "/error", rect, rect.high.y, side->estimate ? quiet_text() : plain,
                       longest_that_fits(error_texts(session.words, *side), room), align_right);
    } else {
        draw_text_line(session, name + "/error", rect, rect.high.y, quiet_text(), session.text("caption.not_measured"),
                       align_right);
    }
    if (!run_time) {
        return;
    }
    const Technique &technique = session.technique(right);
    const bool halves = technique.precision == Precision::medium && technique.model != Model::own &&
                        (right || !session.document.left_is_textbook());
    if (halves && side != nullptr && side->metrics) {
        const std::vector<std::string> texts = device_texts(session.words, *side);
        draw_text_line(session, name + "/device", rect, rect.high.y + line, plain, longest_that_fits(texts, room),
                       align_right);
        if (ImGui::IsMouseHoveringRect({rect.low.x, rect.high.y + line}, {rect.high.x, rect.high.y + 2 * line})) {
            session.hint = texts.front();
        }
        return;
    }
    const bool timed = session.appearance.run_times && side != nullptr && side->time;
    draw_text_line(session, name + "/time", rect, rect.high.y + line, plain,
                   timed ? longest_that_fits(time_texts(session.words, *side->time), room) : "", align_right);
}

} // namespace

std::string shortened(std::string text, float width) {
    const auto fits = [&](const std::string &t) { return ImGui::CalcTextSize(t.c_str()).x <= width; };
    if (fits(text)) {
        return text;
    }
    while (!text.empty() && !fits(text + " ...")) {
        text.erase(last_break(text));
    }
    return text + " ...";
}

float captions_above() { return ImGui::GetFrameHeight() * 3; }
float captions_below() { return ImGui::GetFrameHeight() * 2; }

void draw_text_line(Session &session, const std::string &name, const Rect &rect, float y, ImVec4 color,
                    const std::string &text, bool align_right) {
    constexpr float margin = 6;
    const float left = rect.low.x + margin;
    const float x = align_right ? std::max(left, rect.high.x - margin - ImGui::CalcTextSize(text.c_str()).x) : left;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.PushClipRect({x, y}, {rect.high.x, y + ImGui::GetFrameHeight()}, true);
    list.AddText({x, y + ImGui::GetStyle().FramePadding.y}, ImGui::GetColorU32(color), text.c_str());
    list.PopClipRect();
    describe_text(session, name, {x, y}, {rect.high.x, y + ImGui::GetFrameHeight()}, text);
}

void draw_header(Session &session, const ViewPainter &painter, ImVec2 corner, float width) {
    const float line = ImGui::GetFrameHeight();
    const Rect rect{corner, {corner.x + width, corner.y + 2 * line}};
    draw_text_line(session, "View/differ", rect, corner.y, ImGui::GetStyleColorVec4(ImGuiCol_Text),
                   header_text(session, painter), false);
    const std::string description = file_text(session.words, session.document.scene.description);
    draw_text_line(session, "View/description", rect, corner.y + line, ImGui::GetStyleColorVec4(ImGuiCol_Text),
                   shortened(description, width - ImGui::GetFontSize()), false);
    if (ImGui::IsMouseHoveringRect({corner.x, corner.y + line}, rect.high)) {
        session.hint = description;
    }
}

void draw_captions(Session &session, const ViewPainter &painter, const Rect &picture, bool right, bool align_right,
                   bool run_time) {
    const float y = picture.low.y - ImGui::GetFrameHeight();
    const std::string name = side_name(session, right);
    draw_text_line(session, right ? "B/name" : "A/name", picture, y, side_color(right),
                   shortened(name, picture.width() - ImGui::GetFontSize()), align_right);
    if (ImGui::IsMouseHoveringRect({picture.low.x, y}, {picture.high.x, picture.low.y})) {
        session.hint = name;
    }
    draw_figures(session, painter, picture, right, align_right, run_time);
}

void draw_truth_captions(Session &session, const Rect &picture, bool right) {
    draw_text_line(session, "Truth/name", picture, picture.low.y - ImGui::GetFrameHeight(),
                   ImGui::GetStyleColorVec4(ImGuiCol_Text),
                   shortened(truth_label(session.words, truth_of(session.technique(right), session.technique(!right)),
                                         session.document.mesh_factors[right ? 1 : 0]),
                             picture.width() - ImGui::GetFontSize()),
                   false);
}

void draw_mask_legend(const Session &session, const ViewPainter &painter, const Rect &picture, bool right,
                      bool align_right) {
    if (!session.view.masks || painter.view(right).texture == 0) {
        return;
    }
    const Findings *findings = painter.findings();
    const SideFindings *side = findings != nullptr ? &findings->sides[right ? 1 : 0] : nullptr;
    const std::vector<LegendLine> lines = side == nullptr || !side->metrics || side->uses.empty()
                                              ? std::vector<LegendLine>{{{}, session.text("mask.not_measured")}}
                                              : mask_legend(session.words, *side->metrics);
    float widest = 0;
    for (const auto &[color, text] : lines) {
        widest = std::max(widest, ImGui::CalcTextSize(text.c_str()).x + (color ? ImGui::GetFontSize() * 1.2F : 0));
    }
    const float spacing = ImGui::GetTextLineHeightWithSpacing(), whole = ImGui::GetFontSize();
    const float rows = static_cast<float>(lines.size());
    const float fit = std::min({1.0F, picture.width() / (widest + whole), // smaller text where there is little room
                                0.8F * picture.height() / (spacing * rows + whole * 0.5F)});
    const float em = whole * fit, line = spacing * fit;
    const ImVec2 size{widest * fit + em, line * rows + em * 0.5F};
    const float x = align_right ? picture.high.x - size.x : picture.low.x;
    float y = picture.high.y - size.y;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.PushClipRect(picture.low, picture.high, true);
    list.AddRectFilled({x, y}, {x + size.x, y + size.y}, IM_COL32(16, 18, 22, 235));
    y += em * 0.3F;
    for (const auto &[color, text] : lines) {
        const float left = x + em * 0.5F;
        if (color) {
            list.AddRectFilled({left, y + em * 0.15F}, {left + em * 0.8F, y + em * 0.95F},
                               IM_COL32((*color)[0], (*color)[1], (*color)[2], 255));
        }
        list.AddText(ImGui::GetFont(), em, {color ? left + em * 1.2F : left, y}, IM_COL32(240, 240, 240, 255),
                     text.c_str());
        y += line;
    }
    list.PopClipRect();
}

} // namespace sandbox
