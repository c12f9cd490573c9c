#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sandbox {

struct Contender {
    std::string name;
    std::function<void()> frame; ///< draws one frame and waits for it
};

/// Milliseconds per frame, one entry a turn.
using Turns = std::vector<double>;

struct Quartiles {
    double low, median, high;
};
Quartiles quartiles(std::vector<double> values);

/// Two contenders take turns of `frames` frames (who begins alternates), the first `warm_ups` turns unrecorded.
struct Duel {
    Turns left, right;
};
Duel take_turns(const Contender &left, const Contender &right, int turns, int frames = 10, int warm_ups = 4);

/// One line: both medians with their inter-quartile range, and the median of the paired ratios left / right.
void print_duel(const Contender &left, const Contender &right, const Duel &duel, const std::string &note = "");

} // namespace sandbox
