#pragma once

#include "teach/marking/marker.h"
#include "words/words.h"

#include <string>
#include <vector>

namespace sandbox {

constexpr int most_hints = 3;

/// What helps, a sentence or more for each term. `hints` 0: only why an answer was not marked; 1: which term is wrong
/// and where; 2: in which way; 3: by which fault.
std::vector<std::string> sentences(const Words &words, const Exercise &exercise, const Mark &mark, int hints);

/// ... of one term that is not right.
std::string sentence(const Words &words, const Exercise &exercise, const Mark &mark, const TermResult &result,
                     int hints);

std::string title_of(const Words &words, MarkTerm term);

} // namespace sandbox
