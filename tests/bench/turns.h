#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sandbox {

struct Contender {
    std::string name;
    std::function<void()> frame; ///< draws one frame and waits for it
};

/// Milliseconds per frame, one entry a turn: by the wall clock, and of all this process's threads together. Where a
/// program draws in software, the second is the steadier on a machine that others use too.
struct Turns {
    std::vector<double> wall, cpu;
};

struct Quartiles {
    double low, median, high;
};
Quartiles quartiles(std::vector<double> values);

/// Two contenders take turns of `frames` frames (who begins alternates), the first `warm_ups` turns unrecorded.
struct Duel {
    Turns left, right;
};
Duel take_turns(const Contender &left, const Contender &right, int turns, int frames = 10, int warm_ups = 4);

/// One line: both medians with their inter-quartile range, and the medians of the paired ratios left / right.
void print_duel(const Contender &left, const Contender &right, const Duel &duel, const std::string &note = "");

} // namespace sandbox
