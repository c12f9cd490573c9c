#pragma once

#include "measure/stability/stability.h"
#include "ui/session/document.h"
#include "words/words.h"

#include <optional>
#include <string>
#include <vector>

/// The stability cases as the window lists them: what is known of each, which are shown, how one is opened.
namespace sandbox {

struct ListedCase {
    StabilityCase definition;
    std::optional<StabilityResult> result; ///< none: not run yet
    [[nodiscard]] const std::string &name() const { return definition.name; }
};

std::vector<ListedCase> list_cases(std::vector<StabilityCase> cases);

enum class Verdict { not_run, holds, breaks };

/// Of the textbook's form, and of the program's own, which must hold for all of the case's techniques.
Verdict textbook_verdict(const ListedCase &listed);
Verdict robust_verdict(const ListedCase &listed);
std::string verdict_word(const Words &words, Verdict verdict); ///< "not run", "holds", "breaks"
/// "not run", "holds, 1.2e-06", "breaks, 0.31", "breaks, 3 not finite".
std::string textbook_text(const Words &words, const ListedCase &listed);
std::string robust_text(const Words &words, const ListedCase &listed);
/// "1.04x", or nothing where there is no cost.
std::string cost_text(const ListedCase &listed);

/// "39 of 106 run: robust holds in all, the textbook breaks in 12"
std::string summary(const Words &words, const std::vector<ListedCase> &cases);

/// The name without its group, under which it is listed: "light-on-the-surface".
std::string short_name(const StabilityCase &definition);

struct CaseFilter {
    std::string group;            ///< empty: all
    bool textbook_breaks = false; ///< only where it is known to
};
bool is_shown(const ListedCase &listed, const CaseFilter &filter);
/// The cases shown under one title, by number; without a title while nothing was run.
struct CaseList {
    std::string title;
    std::vector<std::size_t> cases;
};
/// Where the textbook's form breaks, what was not run, where nothing breaks; lists without a case are left out.
std::vector<CaseList> lists_of(const Words &words, const std::vector<ListedCase> &cases, const CaseFilter &filter);
/// Every group once, in order.
std::vector<std::string> groups_of(const std::vector<ListedCase> &cases);

/// A is the textbook's form (on the processor where no program has it), B the robust one; the whole of the case's
/// square picture is seen. `exposure`: see stability_exposure().
Document case_document(const StabilityCase &definition, double exposure);

/// What was run, in the order of the list.
std::vector<StabilityResult> results_of(const std::vector<ListedCase> &cases);

} // namespace sandbox
