#pragma once

#include "measure/stability/stability.h"
#include "words/words.h"

#include <string>
#include <vector>

/// The results of stability cases as stability.html, stability.json, stability.csv and as a table for the terminal, in
/// two lists: where the textbook's form breaks on the renderer at hand, and where it does not.
namespace sandbox {

struct StabilityRun {
    std::vector<StabilityResult> results;
    std::string renderer, version;
    Words words = words_in(languages.front()); ///< of the page and the table
};
std::string stability_html(const StabilityRun &run);
std::string stability_json(const StabilityRun &run);
std::string stability_csv(const StabilityRun &run);
std::string stability_table(const StabilityRun &run);

/// The keys of the titles of the two lists.
constexpr std::string_view breaks_title = "stability.breaks_title";
constexpr std::string_view holds_title = "stability.holds_title";

/// "float32 on the processor, per vertex", "the renderer's per-pixel/phong:power=naive"; and where it is kept, if in
/// half floats.
std::string textbook_words(const Words &words, const StabilityCase &judged);
/// "nothing breaks on this renderer; seen on: ..."
std::string seen_on_words(const Words &words, const StabilityCase &judged);
/// "1.00e-06 of the brightest value"
std::string bound_words(const Words &words, const StabilityCase &judged);
/// "1.04 times the textbook's run time"; nothing if it was not timed.
std::string cost_words(const Words &words, const StabilityResult &result);
/// The largest error, or how many pixels are not finite: "1.2e-06", "3 not finite".
std::string error_words(const Words &words, const StabilityRow &row);

} // namespace sandbox
