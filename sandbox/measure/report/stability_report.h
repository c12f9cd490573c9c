#pragma once

#include "measure/stability/stability.h"

#include <string>
#include <vector>

/// The results of stability cases as stability.html, stability.json, stability.csv and as a table for the terminal.
namespace sandbox {

struct StabilityRun {
    std::vector<StabilityResult> results;
    std::string renderer, version;
};
std::string stability_html(const StabilityRun &run);
std::string stability_json(const StabilityRun &run);
std::string stability_csv(const StabilityRun &run);
std::string stability_table(const StabilityRun &run);

/// "1.00e-06 of the brightest value"
std::string bound_words(const StabilityCase &judged);
/// "1.04 times the textbook's run time"; nothing if it was not timed.
std::string cost_words(const StabilityResult &result);
/// The largest error, or how many pixels are not finite: "1.2e-06", "3 not finite".
std::string error_words(const StabilityRow &row);

} // namespace sandbox
