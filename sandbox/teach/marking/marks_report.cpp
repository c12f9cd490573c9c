#include "teach/marking/marks_report.h"

#include "image/plain_text.h"
#include "measure/report/csv.h"
#include "teach/marking/answer_names.h"
#include "teach/marking/sentences.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

std::string number(double value) { return fmt::format("{:g}", value); }

std::string points_text(const Exercise &exercise, const Mark &mark) {
    return mark.unknown ? "-" : number(mark.judgement.points(exercise));
}

/// For programs: "no-max", "gate=none".
std::string name_of(const Fault &fault) {
    if (fault.setting >= 0) {
        const TechniqueKey &key = technique_settings[fault.setting];
        return fmt::format("{}={}", key.name, key.values[static_cast<std::size_t>(fault.setting_value)].name);
    }
    const auto last_part = [](const std::string &key) { return key.substr(key.find('.', key.find('.') + 1) + 1); };
    const std::string name = last_part(fault.key) + (fault.other.empty() ? "" : " or " + last_part(fault.other));
    return plain_text(fault.value.empty() || name.ends_with(fault.value) ? name : name + "=" + fault.value);
}

} // namespace

std::string marks_table(const Words &words, const Exercise &exercise, std::span<const MarkedAnswer> answers) {
    std::string out = fmt::format("{}: {} ({})\n", exercise.name, exercise.title.text, number(exercise.points()));
    for (const MarkedAnswer &answer : answers) {
        out += fmt::format("{:>6}  {}", points_text(exercise, answer.mark), plain_text(answer.name));
        std::string terms;
        for (std::size_t i = 0; i < answer.mark.judgement.terms.size(); ++i) {
            const TermPoints &row = exercise.terms[i];
            terms += fmt::format("{}{} {}/{}", i == 0 ? "" : ", ", title_of(words, row.term),
                                 number(points_of(row, answer.mark.judgement.terms[i])), number(row.points));
        }
        out += terms.empty() || !answer.mark.refused.empty() ? "\n" : fmt::format("  ({})\n", terms);
        for (const std::string &sentence : answer.said) {
            out += fmt::format("        {}\n", sentence);
        }
    }
    return out;
}

std::string marks_json(const Exercise &exercise, std::span<const MarkedAnswer> answers) {
    ordered_json all = ordered_json::array();
    for (const MarkedAnswer &answer : answers) {
        const Mark &mark = answer.mark;
        ordered_json terms = ordered_json::array(), faults = ordered_json::array();
        for (std::size_t i = 0; i < mark.judgement.terms.size(); ++i) {
            const TermResult &result = mark.judgement.terms[i];
            terms.push_back({{"term", term_words[static_cast<std::size_t>(result.term)]},
                             {"points", points_of(exercise.terms[i], result)},
                             {"of", exercise.terms[i].points},
                             {"right", result.right},
                             {"pictures", result.units}});
        }
        for (const Fault &fault : mark.faults) {
            faults.push_back(name_of(fault));
        }
        all.push_back({{"name", plain_text(answer.name)},
                       {"points", mark.unknown ? ordered_json() : ordered_json(mark.judgement.points(exercise))},
                       {"terms", std::move(terms)},
                       {"faults", std::move(faults)},
                       {"refused", !mark.refused.empty()},
                       {"said", answer.said}});
    }
    const ordered_json json{
        {"format", "shading-sandbox marks 1"}, {"version", SANDBOX_VERSION}, {"exercise", exercise.name},
        {"title", exercise.title.text},        {"of", exercise.points()},    {"answers", std::move(all)}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string marks_csv(const Exercise &exercise, std::span<const MarkedAnswer> answers) {
    CsvTable table;
    for (const MarkedAnswer &answer : answers) {
        const Mark &mark = answer.mark;
        table.begin_row();
        table.cell("answer", plain_cell(answer.name));
        table.cell("points", mark.unknown ? std::nan("") : mark.judgement.points(exercise));
        table.cell("of", exercise.points());
        for (std::size_t i = 0; i < exercise.terms.size(); ++i) {
            table.cell(std::string(term_words[static_cast<std::size_t>(exercise.terms[i].term)]),
                       mark.unknown ? std::nan("") : points_of(exercise.terms[i], mark.judgement.terms[i]));
        }
        table.cell("said", plain_cell(fmt::format("{}", fmt::join(answer.said, " "))));
    }
    return table.text();
}

} // namespace sandbox
