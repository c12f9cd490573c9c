#pragma once

#include "shading/technique.h"

#include <cstddef>
#include <string>
#include <vector>

namespace sandbox {

/// What somebody might hand in.
struct ClassAnswer {
    std::string name; ///< of the file: "007-right.glsl", "012-no-max.glsl"
    std::string text;
    std::string fault; ///< empty: right, only written in another way
    std::string term;  ///< that the fault is in
};

/// Answers to exercises of the technique's model, by chance: each line in one of several ways that are right, and in
/// about three of five answers one line in a way that is wrong. The same seed gives the same class. Only faults of the
/// `terms` are made.
std::vector<ClassAnswer> answer_class(const Technique &target, const std::vector<std::string> &terms, std::size_t count,
                                      unsigned seed);

} // namespace sandbox
