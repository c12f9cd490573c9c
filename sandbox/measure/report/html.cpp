#include "measure/report/html.h"

#include "image/image_file.h"
#include "image/plain_text.h"
#include "scene/assets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sandbox::html {

std::string escaped(std::string_view text) {
    constexpr std::pair<char, std::string_view> entities[]{
        {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
    std::string out;
    for (const char c : plain_lines(text)) {
        const auto *entity = std::ranges::find(entities, c, &std::pair<char, std::string_view>::first);
        out += entity == std::end(entities) ? std::string(1, c) : std::string(entity->second);
    }
    return out;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned triple = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            triple = triple << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += k <= count ? digits[triple >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return out;
}

void Table::text(std::string_view html, std::string_view style) {
    rows_.back().push_back({fmt::format(R"(<td class="{}">{}</td>)", style, html), false});
}

void Table::number(double value, std::string_view html, std::string_view style) {
    const double key = std::isfinite(value) ? value : 1e300;
    rows_.back().push_back({fmt::format(R"(<td class="n {}" data-v="{:.9g}">{}</td>)", style, key, html), true});
}

void Table::rest(std::string_view html, std::string_view style) {
    const std::size_t columns = heads_.size() - rows_.back().size();
    rows_.back().push_back({fmt::format(R"(<td class="{}" colspan="{}">{}</td>)", style, columns, html), false});
}

std::string Table::html() const {
    std::string head, body;
    for (std::size_t i = 0; i < heads_.size(); ++i) {
        const bool number =
            std::ranges::any_of(rows_, [i](const auto &row) { return i < row.size() && row[i].number; });
        head += fmt::format("<th{}>{}</th>", number ? " class=\"n\"" : "", heads_[i]);
    }
    for (const auto &row : rows_) {
        body += "<tr>";
        for (const Cell &cell : row) {
            body += cell.html;
        }
        body += "</tr>\n";
    }
    const std::string caption = caption_.empty() ? "" : fmt::format("<caption>{}</caption>", caption_);
    return rows_.empty() ? ""
                         : fmt::format("<div class=\"scroll\"><table>{}<thead><tr>{}</tr></thead>\n<tbody>{}</tbody>"
                                       "</table></div>\n",
                                       caption, head, body);
}

std::vector<std::string> heads_of(const Words &words, std::initializer_list<std::string_view> names) {
    std::vector<std::string> heads;
    for (const std::string_view name : names) {
        heads.push_back(words.text(fmt::format("report.column.{}", name)));
    }
    return heads;
}

std::string page(const Words &words, std::string_view title, std::string_view body) {
    const Assets assets("assets");
    return fmt::format(R"(<!DOCTYPE html>
<html lang="{}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{}</title>
<style>
{}</style>
</head>
<body>
<main>
{}</main>
<script>
{}</script>
</body>
</html>
)",
                       words.language(), escaped(title), assets.read("page/style.css").value_or(""), body,
                       assets.read("page/script.js").value_or(""));
}

std::string section(std::string_view style, std::string_view title, std::string_view lead, std::string_view body) {
    return body.empty()
               ? ""
               : fmt::format("<section class=\"{}\"><h2>{}</h2>\n<p>{}</p>\n{}</section>\n", style, title, lead, body);
}

std::string card(std::string_view top, std::string_view big, std::string_view below, bool words) {
    return fmt::format("<div class=\"card\"><span class=\"top\">{}</span><b class=\"{}\">{}</b><span>{}</span></div>\n",
                       top, words ? "words" : "", big, below);
}

std::string figure(std::string_view title, std::string_view caption, std::string_view number, const ByteImage &image) {
    return fmt::format("<figure><img alt=\"{0}: {1} {2}\" src=\"data:image/png;base64,{3}\"><figcaption><b>{0}</b>{1} "
                       "<span class=\"together\">{2}</span></figcaption></figure>\n",
                       escaped(title), escaped(caption), escaped(number), base64(encode_png(image)));
}

std::string technique_code(const Technique &technique) {
    return fmt::format("<code>{}</code>", escaped(to_string(technique)));
}

std::string ratio_text(const TimeRatio &ratio) {
    return fmt::format(R"({:.2f} <span class="q">[{:.2f}, {:.2f}]</span>)", ratio.median, ratio.lower_quartile,
                       ratio.upper_quartile);
}

} // namespace sandbox::html
