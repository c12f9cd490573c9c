#include "turns.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace sandbox {
namespace {

double milliseconds_per_frame(const Contender &contender, int frames) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < frames; ++i) {
        contender.frame();
    }
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() / frames;
}

} // namespace

Quartiles quartiles(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const auto above = std::min(below + 1, values.size() - 1);
        return std::lerp(values[below], values[above], place - std::floor(place));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

Duel take_turns(const Contender &left, const Contender &right, int turns, int frames, int warm_ups) {
    Duel duel;
    for (int turn = -warm_ups; turn < turns; ++turn) {
        const bool left_begins = turn % 2 == 0;
        const double first = milliseconds_per_frame(left_begins ? left : right, frames);
        const double second = milliseconds_per_frame(left_begins ? right : left, frames);
        if (turn >= 0) {
            duel.left.push_back(left_begins ? first : second);
            duel.right.push_back(left_begins ? second : first);
        }
    }
    return duel;
}

void print_duel(const Contender &left, const Contender &right, const Duel &duel, const std::string &note) {
    std::vector<double> ratios(duel.left.size());
    std::transform(duel.left.begin(), duel.left.end(), duel.right.begin(), ratios.begin(), std::divides<>());
    const auto [left_low, left_median, left_high] = quartiles(duel.left);
    const auto [right_low, right_median, right_high] = quartiles(duel.right);
    const auto [ratio_low, ratio_median, ratio_high] = quartiles(ratios);
    std::printf("%-44s %7.3f ms [%.3f %.3f] | %s %.3f ms [%.3f %.3f] | ratio %.3f [%.3f %.3f]%s\n", left.name.c_str(),
                left_median, left_low, left_high, right.name.c_str(), right_median, right_low, right_high, ratio_median,
                ratio_low, ratio_high, note.c_str());
    std::fflush(stdout);
}

} // namespace sandbox
