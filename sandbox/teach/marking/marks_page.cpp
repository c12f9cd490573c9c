#include "teach/marking/marks_page.h"

#include "image/difference.h"
#include "image/plain_text.h"
#include "measure/report/html.h"
#include "teach/marking/sentences.h"
#include "words/row_words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace sandbox {
namespace {

std::string number(double value) { return fmt::format("{:g}", value); }

std::string points_words(const Words &words, const Exercise &exercise, const Mark &mark) {
    return mark.unknown
               ? words.text("mark.page.no_points")
               : words.format("mark.page.points", number(mark.judgement.points(exercise)), number(exercise.points()));
}

/// So strong that the largest difference has the strongest colour, in plain steps.
double gain_of(double largest) {
    constexpr double most = 50;
    return std::isfinite(largest) && largest > 0 ? std::clamp(std::round(1 / largest), 1.0, most) : 1;
}

std::string figures(const Words &words, const Exercise &exercise, const Mark &mark) {
    const bool student = !mark.student.pixels.empty(), truth = !mark.truth.pixels.empty();
    if (!student || !truth) {
        return "";
    }
    const std::string caption = words.format("mark.page.caption", file_text(words, exercise.scenes.front().name));
    const double gain = gain_of(largest_difference(mark.student, mark.truth));
    return "<div class=\"figures\">" +
           html::figure(words.text("mark.page.student"), caption, "", to_display(mark.student)) +
           html::figure(words.text("mark.page.truth"), caption, "", to_display(mark.truth)) +
           html::figure(words.text("mark.page.difference"), words.format("mark.page.difference.caption", number(gain)),
                        "", difference_picture(mark.student, mark.truth, gain)) +
           "</div>\n";
}

std::string terms_table(const Words &words, const Exercise &exercise, const Mark &mark) {
    if (mark.unknown) {
        return "";
    }
    html::Table table({words.text("mark.page.term"), words.text("mark.page.term_points"),
                       mark.of_picture || !mark.refused.empty() ? "" : words.text("mark.page.pictures")});
    for (std::size_t i = 0; i < exercise.terms.size(); ++i) {
        const TermPoints &row = exercise.terms[i];
        const TermResult &result = mark.judgement.terms[i];
        table.begin_row();
        table.text(html::escaped(title_of(words, row.term)), result.is_right() || result.spared ? "" : "bad");
        const double points = points_of(row, result);
        table.text(html::escaped(words.format("mark.page.points", number(points), number(row.points))));
        table.text(result.units == 0 || mark.of_picture
                       ? ""
                       : html::escaped(words.format("mark.page.pictures_right", result.right, result.units)));
    }
    return table.html();
}

std::string said_list(const Words &words, const std::vector<std::string> &said) {
    std::string items;
    for (const std::string &sentence : said) {
        items += fmt::format("<li>{}</li>\n", html::escaped(sentence));
    }
    return items.empty()
               ? ""
               : fmt::format("<h2>{}</h2>\n<ul>\n{}</ul>\n", html::escaped(words.text("mark.page.said")), items);
}

/// A page's name in a link: bytes beside plain ones as %NN.
std::string link_to(const std::string &page) {
    std::string out;
    for (const char c : page) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 || c == '-' || c == '_' || c == '.');
        out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return out;
}

std::string header(const Words &words, const Exercise &exercise, const std::string &title, const std::string &lead) {
    return fmt::format("<header><p class=\"kicker\">{}</p><h1>{}</h1><p class=\"lead\">{}</p></header>\n",
                       html::escaped(words.format("mark.page.exercise", exercise.title.text)), html::escaped(title),
                       html::escaped(lead));
}

} // namespace

std::string mark_html(const Words &words, const Exercise &exercise, const MarkedAnswer &answer) {
    const std::string name = plain_text(answer.name);
    return html::page(words, name,
                      header(words, exercise, name, points_words(words, exercise, answer.mark)) +
                          figures(words, exercise, answer.mark) + said_list(words, answer.said) +
                          terms_table(words, exercise, answer.mark));
}

std::string marks_index(const Words &words, const Exercise &exercise, std::span<const MarkedAnswer> answers) {
    std::vector<std::string> heads{words.text("mark.page.answer"), words.text("mark.page.term_points")};
    for (const TermPoints &row : exercise.terms) {
        heads.push_back(html::escaped(title_of(words, row.term)));
    }
    html::Table table(heads);
    double sum = 0;
    for (const MarkedAnswer &answer : answers) {
        const Mark &mark = answer.mark;
        const double points = mark.judgement.points(exercise);
        sum += points;
        table.begin_row();
        table.text(fmt::format("<a href=\"{}\">{}</a>", link_to(answer.page), html::escaped(plain_text(answer.name))));
        table.number(mark.unknown ? -1 : points, mark.unknown ? "-" : number(points));
        for (std::size_t i = 0; i < exercise.terms.size(); ++i) {
            const double own = mark.unknown ? 0 : points_of(exercise.terms[i], mark.judgement.terms[i]);
            const bool whole = own == exercise.terms[i].points;
            table.number(own, mark.unknown ? "-" : number(own), whole || mark.unknown ? "" : "bad");
        }
    }
    const double mean = answers.empty() ? 0 : sum / static_cast<double>(answers.size());
    const std::string lead =
        words.format("mark.page.mean", answers.size(), number(std::round(100 * mean) / 100), number(exercise.points()));
    const std::string title = words.text("mark.page.class");
    return html::page(words, title, header(words, exercise, title, lead) + table.html());
}

} // namespace sandbox
