#include "ui/jobs/stability_list.h"

#include "measure/report/stability_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sandbox {

namespace {

constexpr std::string_view not_run_title = "stability.not_run_title";

Verdict verdict_of(bool passed) { return passed ? Verdict::holds : Verdict::breaks; }

std::string verdict_text(const Words &words, Verdict verdict, const StabilityRow &row) {
    return words.format("verdict.figure", verdict_word(words, verdict), error_words(words, row));
}

} // namespace

std::vector<ListedCase> list_cases(std::vector<StabilityCase> cases) {
    std::vector<ListedCase> list;
    list.reserve(cases.size());
    for (StabilityCase &definition : cases) {
        list.push_back({std::move(definition), std::nullopt});
    }
    return list;
}

Verdict textbook_verdict(const ListedCase &listed) {
    return listed.result ? verdict_of(listed.result->textbook.passed) : Verdict::not_run;
}

Verdict robust_verdict(const ListedCase &listed) {
    return listed.result ? verdict_of(listed.result->passed()) : Verdict::not_run;
}

std::string verdict_word(const Words &words, Verdict verdict) {
    constexpr std::string_view keys[] = {"verdict.not_run", "verdict.holds", "verdict.breaks"};
    return words.text(keys[static_cast<int>(verdict)]);
}

std::string textbook_text(const Words &words, const ListedCase &listed) {
    return listed.result ? verdict_text(words, textbook_verdict(listed), listed.result->textbook)
                         : verdict_word(words, Verdict::not_run);
}

std::string robust_text(const Words &words, const ListedCase &listed) {
    return listed.result ? verdict_text(words, robust_verdict(listed), listed.result->worst())
                         : verdict_word(words, Verdict::not_run);
}

std::string cost_text(const ListedCase &listed) {
    const auto cost = listed.result ? listed.result->cost_ratio() : std::nullopt;
    return cost ? fmt::format("{:.2f}x", *cost) : "";
}

std::string summary(const Words &words, const std::vector<ListedCase> &cases) {
    const auto count = [&](Verdict (*verdict)(const ListedCase &), Verdict wanted) {
        return std::ranges::count_if(cases, [&](const ListedCase &listed) { return verdict(listed) == wanted; });
    };
    const auto broken = count(robust_verdict, Verdict::breaks);
    const auto run = count(robust_verdict, Verdict::holds) + broken;
    if (run == 0) {
        return words.format("stability.none_run", cases.size());
    }
    const auto textbook = count(textbook_verdict, Verdict::breaks);
    const auto count_text = [&](auto number, std::string_view none, std::string_view some) {
        return number == 0 ? words.text(none) : words.format(some, number);
    };
    return words.format("stability.summary", run, cases.size(),
                        count_text(broken, "stability.robust_holds", "stability.robust_breaks"),
                        count_text(textbook, "stability.in_none", "stability.in"));
}

std::string short_name(const StabilityCase &definition) {
    const std::string prefix = definition.group + "-";
    return definition.name.starts_with(prefix) ? definition.name.substr(prefix.size()) : definition.name;
}

bool is_shown(const ListedCase &listed, const CaseFilter &filter) {
    return (filter.group.empty() || listed.definition.group == filter.group) &&
           (!filter.textbook_breaks || textbook_verdict(listed) == Verdict::breaks);
}

std::vector<CaseList> lists_of(const Words &words, const std::vector<ListedCase> &cases, const CaseFilter &filter) {
    std::vector<CaseList> lists;
    for (const auto &[verdict, title] :
         {std::pair(Verdict::breaks, breaks_title), std::pair(Verdict::not_run, not_run_title),
          std::pair(Verdict::holds, holds_title)}) {
        CaseList list;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (textbook_verdict(cases[i]) == verdict && is_shown(cases[i], filter)) {
                list.cases.push_back(i);
            }
        }
        list.title = words.format("stability.list", words.text(title), list.cases.size());
        if (!list.cases.empty()) {
            lists.push_back(std::move(list));
        }
    }
    if (std::ranges::none_of(cases, [](const ListedCase &listed) { return listed.result.has_value(); })) {
        for (CaseList &list : lists) {
            list.title.clear();
        }
    }
    return lists;
}

std::vector<std::string> groups_of(const std::vector<ListedCase> &cases) {
    std::vector<std::string> groups;
    for (const ListedCase &listed : cases) {
        if (std::ranges::find(groups, listed.definition.group) == groups.end()) {
            groups.push_back(listed.definition.group);
        }
    }
    return groups;
}

Document case_document(const StabilityCase &definition, double exposure) {
    const Technique robust = definition.techniques.front();
    Document document = document_of(definition.name, definition.scene, definition.textbook.value_or(robust), robust);
    if (!definition.textbook) {
        document.textbook = robust;
    }
    document.exposure = exposure;
    document.least_aspect = 1;
    return document;
}

std::vector<StabilityResult> results_of(const std::vector<ListedCase> &cases) {
    std::vector<StabilityResult> results;
    for (const ListedCase &listed : cases) {
        if (listed.result) {
            results.push_back(*listed.result);
        }
    }
    return results;
}

} // namespace sandbox
