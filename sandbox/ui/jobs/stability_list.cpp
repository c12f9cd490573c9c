#include "ui/jobs/stability_list.h"

#include "measure/report/text.h"

#include <algorithm>
#include <cstdio>

namespace sandbox {

namespace {

Verdict verdict_of(bool passed) { return passed ? Verdict::holds : Verdict::breaks; }

std::string verdict_text(Verdict verdict, const StabilityRow &row) {
    return verdict_word(verdict) + (", " + figure_text(row));
}

} // namespace

std::vector<ListedCase> list_cases(std::vector<StabilityCase> cases) {
    std::vector<ListedCase> list;
    list.reserve(cases.size());
    for (StabilityCase &one : cases) {
        list.push_back({std::move(one), std::nullopt});
    }
    return list;
}

Verdict textbook_verdict(const ListedCase &one) {
    return one.result ? verdict_of(one.result->textbook.passed) : Verdict::not_run;
}

Verdict robust_verdict(const ListedCase &one) {
    return one.result ? verdict_of(one.result->passed()) : Verdict::not_run;
}

const char *verdict_word(Verdict verdict) {
    constexpr const char *words[] = {"not run", "holds", "breaks"};
    return words[static_cast<int>(verdict)];
}

std::string figure_text(const StabilityRow &row) {
    const auto bad = row.metrics.nonfinite_pixels;
    return bad > 0 ? std::to_string(bad) + " not finite" : short_number(row.error);
}

std::string textbook_text(const ListedCase &one) {
    return one.result ? verdict_text(textbook_verdict(one), one.result->textbook) : verdict_word(Verdict::not_run);
}

std::string robust_text(const ListedCase &one) {
    return one.result ? verdict_text(robust_verdict(one), one.result->worst()) : verdict_word(Verdict::not_run);
}

std::string cost_text(const ListedCase &one) {
    if (!one.result || !one.result->cost) {
        return "";
    }
    char text[24];
    std::snprintf(text, sizeof text, "%.2fx", *one.result->cost);
    return text;
}

std::string summary(const std::vector<ListedCase> &cases) {
    const auto count = [&](Verdict (*verdict)(const ListedCase &), Verdict wanted) {
        return std::ranges::count_if(cases, [&](const ListedCase &one) { return verdict(one) == wanted; });
    };
    const auto broken = count(robust_verdict, Verdict::breaks);
    const auto run = count(robust_verdict, Verdict::holds) + broken;
    const std::string all = std::to_string(cases.size());
    if (run == 0) {
        return all + " cases, none run yet";
    }
    const auto some = [](auto number) { return number == 0 ? std::string("none") : std::to_string(number); };
    return std::to_string(run) + " of " + all + " run: robust " +
           (broken == 0 ? "holds in all" : "breaks in " + some(broken)) + ", the textbook breaks in " +
           some(count(textbook_verdict, Verdict::breaks));
}

std::string short_name(const StabilityCase &one) {
    const std::string prefix = one.group + "-";
    return one.name.starts_with(prefix) ? one.name.substr(prefix.size()) : one.name;
}

bool is_shown(const ListedCase &one, const CaseFilter &filter) {
    return (filter.group.empty() || one.of.group == filter.group) &&
           (!filter.textbook_breaks || textbook_verdict(one) == Verdict::breaks);
}

std::vector<std::string> groups_of(const std::vector<ListedCase> &cases) {
    std::vector<std::string> groups;
    for (const ListedCase &one : cases) {
        if (std::ranges::find(groups, one.of.group) == groups.end()) {
            groups.push_back(one.of.group);
        }
    }
    return groups;
}

Document case_document(const StabilityCase &one, double exposure) {
    const Technique robust = one.techniques.front();
    Document document = document_of(one.name, one.scene, one.textbook.value_or(robust), robust);
    if (!one.textbook) {
        document.textbook = robust;
    }
    document.exposure = exposure;
    document.least_aspect = 1;
    return document;
}

std::vector<StabilityResult> results_of(const std::vector<ListedCase> &cases) {
    std::vector<StabilityResult> results;
    for (const ListedCase &one : cases) {
        if (one.result) {
            results.push_back(*one.result);
        }
    }
    return results;
}

} // namespace sandbox
