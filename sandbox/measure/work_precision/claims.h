#pragma once

#include "measure/work_precision/findings.h"
#include "words/words.h"

#include <string>
#include <vector>

namespace sandbox {

/// A claim that tutorials make, answered by two rows on the scene's own mesh.
struct Claim {
    std::string says;
    std::size_t row = 0, against = 0;
    TimeRatio time;
    std::string finding; ///< in words, from the numbers alone
};
/// The claims that this measurement can answer, those of the richest model first.
std::vector<Claim> answer_claims(const Words &words, const WorkPrecision &measured);

} // namespace sandbox
