#include "teach/lesson_report.h"

#include "image/png.h"
#include "measure/report/html.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

/// "0.312 linear colour (above 0.3)"
std::string value_words(const ClaimResult &claim) {
    std::string text = claim.measured;
    text += claim.checked && !claim.unit.empty() && !claim.bound.empty() ? fmt::format(" {}", claim.unit) : "";
    return text + (claim.bound.empty() ? "" : fmt::format(" ({})", claim.bound));
}

std::string claims_html(const Words &words, const std::vector<ClaimResult> &claims) {
    html::Table table({words.text("page.claim"), words.text("page.measured"), words.text("page.claimed"), ""});
    for (const ClaimResult &claim : claims) {
        table.begin_row();
        table.text(html::escaped(claim.what));
        table.text(html::escaped(claim.measured));
        table.text(html::escaped(claim.bound));
        table.text(words.text(!claim.checked ? "page.shown"
                              : claim.passed ? "page.holds"
                                             : "page.fails"),
                   claim.passed ? "" : "bad");
    }
    return table.html();
}

std::string techniques_words(const Words &words, const LessonStep &step) {
    const std::string left = html::technique_code(*step.left), right = html::technique_code(*step.right);
    return step.layout == StepLayout::single ? left : words.format("technique.pair", "A " + left, "B " + right);
}

std::string step_html(const Words &words, std::size_t number, const LessonStep &step,
                      const std::vector<ClaimResult> &claims, const ByteImage &picture) {
    const std::string question =
        step.question ? fmt::format("<details><summary>{}</summary><p>{}</p></details>\n",
                                    html::escaped(step.question->asks.text), html::escaped(step.question->answer.text))
                      : "";
    return fmt::format(
        "<section class=\"step\" id=\"step-{0}\"><h2>{0}. {1}</h2>\n<p class=\"lead\">{2}</p>\n"
        "<figure><img alt=\"{1}\" src=\"data:image/png;base64,{3}\"><figcaption>{4}</figcaption></figure>\n"
        "{5}{6}</section>\n",
        number, html::escaped(step.title.text), html::escaped(step.text.text), html::base64(encode_png(picture)),
        techniques_words(words, step), question, claims_html(words, claims));
}

/// Empty of a lesson that is none.
std::string bug_facts(const Words &words, const Lesson &lesson) {
    const auto fact = [&](std::string_view key, const std::string &text) {
        return words.format("page.fact", fmt::format("<b>{}</b>", words.text(key)), html::escaped(text));
    };
    return lesson.is_bug()
               ? fmt::format("<p>{}<br>{}<br>{}</p>", fact("lesson_tab.seen", lesson.seen.text),
                             fact("lesson_tab.cure", lesson.cure.text), fact("lesson_tab.source", lesson.source))
               : "";
}

std::string titled_page(const Words &words, const std::string &title, const std::string &body) {
    return html::page(
        words, title,
        fmt::format("<header><p class=\"kicker\">Shading Sandbox</p><h1>{}</h1></header>\n{}", title, body));
}

} // namespace

std::string lesson_table(const MeasuredLesson &measured) {
    const auto &[lesson, result] = measured;
    std::string out = fmt::format("{}: {}\n", lesson.name, lesson.title.text);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        out += fmt::format("  {}. {}\n", i + 1, lesson.steps[i].title.text);
        for (const ClaimResult &claim : result.steps[i]) {
            out += fmt::format("    {:<6} {}: {}\n",
                               !claim.checked ? "shown"
                               : claim.passed ? "ok"
                                              : "FAILED",
                               claim.what, value_words(claim));
        }
    }
    return out;
}

std::string lessons_json(std::span<const MeasuredLesson> measured, const std::string &renderer) {
    ordered_json lessons = ordered_json::array();
    bool passed = true;
    for (const auto &[lesson, result] : measured) {
        ordered_json steps = ordered_json::array();
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            ordered_json claims = ordered_json::array();
            for (const ClaimResult &claim : result.steps[i]) {
                claims.push_back({{"what", claim.what},
                                  {"value", claim.value},
                                  {"measured", claim.measured},
                                  {"bound", claim.bound},
                                  {"unit", claim.unit},
                                  {"checked", claim.checked},
                                  {"passed", claim.passed}});
            }
            steps.push_back({{"title", lesson.steps[i].title.text}, {"claims", claims}});
        }
        passed = passed && result.passed();
        lessons.push_back(
            {{"name", lesson.name}, {"title", lesson.title.text}, {"passed", result.passed()}, {"steps", steps}});
    }
    const ordered_json all{{"format", "shading-sandbox lessons 1"},
                           {"version", SANDBOX_VERSION},
                           {"renderer", renderer},
                           {"passed", passed},
                           {"lessons", lessons}};
    return all.dump(2) + "\n";
}

std::string lesson_html(const Words &words, const MeasuredLesson &measured, std::span<const ByteImage> pictures,
                        const std::string &renderer) {
    const auto &[lesson, result] = measured;
    std::string body =
        fmt::format(R"(<header><p class="kicker">{}</p><h1>{}</h1><p class="lead">{}</p>{}<p class="facts">{} )"
                    "&middot; {} &middot; Shading Sandbox {}</p></header>\n",
                    words.text(lesson.is_bug() ? "page.bug" : "page.lesson"), html::escaped(lesson.title.text),
                    html::escaped(lesson.about.text), bug_facts(words, lesson), words.text("page.every_claim"),
                    html::escaped(renderer), SANDBOX_VERSION);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        body += step_html(words, i + 1, lesson.steps[i], result.steps[i], pictures[i]);
    }
    return html::page(words, lesson.title.text, body);
}

std::string lessons_index(const Words &words, std::span<const MeasuredLesson> measured) {
    html::Table table({words.text("page.column.lesson"), words.text("page.column.about"),
                       words.text("page.column.steps"), words.text("page.column.claims"), ""});
    for (const auto &[lesson, result] : measured) {
        std::size_t claims = 0;
        for (const auto &step : result.steps) {
            claims += step.size();
        }
        table.begin_row();
        table.text(
            fmt::format("<a href=\"{}.html\">{}</a>", html::escaped(lesson.name), html::escaped(lesson.title.text)));
        table.text(html::escaped(lesson.about.text));
        table.number(static_cast<double>(lesson.steps.size()), fmt::format("{}", lesson.steps.size()));
        table.number(static_cast<double>(claims), fmt::format("{}", claims));
        table.text(words.text(result.passed() ? "page.all_hold" : "page.one_fails"), result.passed() ? "" : "bad");
    }
    return titled_page(words, words.text("page.lessons"), table.html());
}

std::string gallery_sheet(const Words &words, std::span<const MeasuredLesson> measured) {
    std::string figures;
    for (const auto &[lesson, result] : measured) {
        figures +=
            fmt::format("<figure><a href=\"{0}.html\"><img alt=\"{1}\" src=\"{0}-01.png\"></a>"
                        "<figcaption><b>{1}</b>{2}{3}</figcaption></figure>\n",
                        html::escaped(lesson.name), html::escaped(lesson.title.text), bug_facts(words, lesson),
                        result.passed() ? "" : fmt::format("<p class=\"bad\">{}</p>", words.text("page.one_fails")));
    }
    return titled_page(words, words.text("lesson_tab.bugs"), "<div class=\"figures\">" + figures + "</div>\n");
}

} // namespace sandbox
