#include "capture/labels.h"

#include "capture/strokes.h"
#include "image/cut_paste.h"
#include "image/difference.h"
#include "image/system_font.h"
#include "image/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace sandbox {
namespace {

constexpr Rgb paper{24, 26, 30};
constexpr double smallest_text = 6;  // pixels a line; below that strokes run together
constexpr double line_spacing = 1.5; // line boxes
constexpr std::size_t most_lines = 3;
constexpr double scale_width = 52; // in text heights: what stands in a scale, and the gaps

double margin_of(double height) { return height * 0.6; }

/// Where the word that begins at `begin` ends, with the spaces behind it: Chinese may break behind every character, but
/// not before its punctuation.
std::size_t word_end(std::string_view text, std::size_t begin) {
    const auto next = [&](std::size_t at) {
        std::string_view rest = text.substr(at);
        return rest.empty() ? char32_t{0} : take_character(rest);
    };
    const auto closes = [](char32_t c) { return c == U'，' || c == U'。' || c == U'；' || c == U'：' || c == U'）'; };
    std::string_view rest = text.substr(begin);
    while (!rest.empty()) {
        const char32_t character = take_character(rest);
        const std::size_t at = text.size() - rest.size();
        const char32_t following = next(at);
        if (character == ' ' ? following != ' ' : following >= first_chinese && !closes(following)) {
            return at;
        }
        if (character >= first_chinese && character != U'（' && following != ' ' && !closes(following)) {
            return at;
        }
    }
    return text.size();
}

/// `text` in lines of at most `room` pixels, broken between words; a word that is longer has its own line.
std::vector<std::string> wrapped(const std::string &text, double height, double room) {
    std::vector<std::string> lines{""};
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::string word = text.substr(begin, word_end(text, begin) - begin); // with the spaces behind it
        const std::string bare = word.substr(0, word.find_last_not_of(' ') + 1);
        if (!lines.back().empty() && text_width(lines.back() + bare, height) > room) {
            lines.emplace_back();
        }
        lines.back() += word;
        begin += word.size();
    }
    for (std::string &line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
    }
    return lines;
}

/// Where the labels begin and the last one ends.
std::vector<int> columns_for(const LabelTexts &texts, int width, double height) {
    std::vector<int> columns{0};
    columns.insert(columns.end(), texts.splits.begin(), texts.splits.end());
    columns.push_back(width);
    if (texts.splits_move && texts.labels.size() == 2) {
        const auto needs = [&](const std::string &text) {
            return static_cast<int>(std::ceil(text_width(text, height) + 2 * margin_of(height)));
        };
        const int left = needs(texts.labels[0]), right = width - needs(texts.labels[1]);
        columns[1] = left <= right ? std::clamp(columns[1], left, right) : width / 2;
    }
    return columns;
}

/// Places the labels at this height; false if one is not whole or in too many lines.
bool place_labels(Strips &strips, const LabelTexts &texts, int width) {
    const std::vector<int> columns = columns_for(texts, width, strips.text);
    strips.lefts.assign(columns.begin(), columns.end() - 1);
    strips.lines.clear();
    std::size_t most = 0;
    bool whole = true;
    for (std::size_t i = 0; i < texts.labels.size(); ++i) {
        const double room = columns[i + 1] - columns[i] - 2 * margin_of(strips.text);
        strips.lines.push_back(wrapped(texts.labels[i], strips.text, room));
        most = std::max(most, strips.lines.back().size());
        for (const std::string &line : strips.lines.back()) {
            whole = whole && text_width(line, strips.text) <= room;
        }
    }
    strips.above = static_cast<int>(std::ceil(static_cast<double>(most) * line_spacing * strips.text));
    return whole && most <= most_lines;
}

/// The bar's colours and, below it, its numbers.
void draw_bar(ByteImage &picture, double text, double left, double top, double width, double gain) {
    const int from = static_cast<int>(left), to = static_cast<int>(left + width);
    for (int x = from; x < to; ++x) {
        const double value = 2 * (x + 0.5 - from) / (to - from) - 1;
        const glm::vec3 color = difference_color(static_cast<float>(value)) * 255.0F;
        fill_part(picture, x, static_cast<int>(top + 0.3 * text), x + 1, static_cast<int>(top + line_spacing * text),
                  {static_cast<std::uint8_t>(std::lround(color.r)), static_cast<std::uint8_t>(std::lround(color.g)),
                   static_cast<std::uint8_t>(std::lround(color.b))});
    }
    for (int i = -2; i <= 2; ++i) {
        const std::string number = i == 0 ? "0" : fmt::format("{:+.3g}", i / 2.0 / gain);
        const double middle = left + width * (i + 2) / 4.0;
        draw_text(picture, middle - text_width(number, text) / 2, top + 1.7 * text, text, number);
    }
}

} // namespace

Words words_of_labels(const std::string &language) {
    return words_in(chinese_font() ? language : std::string(languages.front()));
}

Strips strips_for(int width, const LabelTexts &texts, double most_text) {
    Strips strips;
    if (texts.labels.empty() && !texts.scale) {
        return strips;
    }
    strips.text = std::min(std::clamp(width / 50.0, 10.0, 64.0), most_text);
    strips.text = texts.scale ? std::min(strips.text, width / scale_width) : strips.text;
    while (strips.text >= smallest_text && !place_labels(strips, texts, width)) {
        strips.text *= 0.95;
    }
    if (strips.text < smallest_text) {
        return {};
    }
    strips.below = texts.scale ? static_cast<int>(std::ceil(3.2 * strips.text)) : 0;
    return strips;
}

void draw_labels(ByteImage &picture, const Strips &strips) {
    fill_part(picture, 0, 0, picture.size.width, strips.above, paper);
    for (std::size_t i = 0; i < strips.lines.size(); ++i) {
        double top = (line_spacing - 1) / 2 * strips.text;
        for (const std::string &line : strips.lines[i]) {
            draw_text(picture, strips.lefts[i] + margin_of(strips.text), top, strips.text, line);
            top += line_spacing * strips.text;
        }
    }
}

void draw_scale(ByteImage &picture, const Strips &strips, const ScaleTexts &texts) {
    const double text = strips.text;
    const double top = picture.size.height - strips.below;
    fill_part(picture, 0, static_cast<int>(top), picture.size.width, picture.size.height, paper);
    draw_text(picture, margin_of(text), top + 0.4 * text, text, texts.what);
    draw_text(picture, margin_of(text), top + 1.7 * text, text, texts.result);
    const std::string &left = texts.low, &right = texts.high;
    const double beside = std::max(text_width(left, text), text_width(right, text)) + text;
    const double results = std::max(text_width(texts.what, text), text_width(texts.result, text)) + text;
    const double from = results + margin_of(text) + beside;
    const double room = picture.size.width - margin_of(text) - beside - from;
    const double width = std::min(room, 30 * text); // beside the picture's middle, as far as there is room
    const double bar = std::max(from, std::min((picture.size.width - width) / 2, from + room - width));
    draw_bar(picture, text, bar, top, width, texts.gain);
    draw_text(picture, bar - text - text_width(left, text), top + 0.4 * text, text, left);
    draw_text(picture, bar + width + text, top + 0.4 * text, text, right);
}

void draw_divider(ByteImage &picture, int split, int top, int rows) {
    const int thickness = std::max(1, rows / 360);
    const int from = std::max(0, split - (thickness + 1) / 2);
    if (thickness > 1) { // edges, so that it is seen between white views, too
        fill_part(picture, from - 1, top, from + thickness + 1, top + rows, paper);
    }
    fill_part(picture, from, top, from + thickness, top + rows, {255, 255, 255});
}

} // namespace sandbox
