#include "turns.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace sandbox {
namespace {

double cpu_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void take_turn(const Contender &contender, int frames, Turns &turns) {
    const auto begin = std::chrono::steady_clock::now();
    const double cpu_begin = cpu_milliseconds();
    for (int i = 0; i < frames; ++i) {
        contender.frame();
    }
    const double wall = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    turns.wall.push_back(wall / frames);
    turns.cpu.push_back((cpu_milliseconds() - cpu_begin) / frames);
}

Quartiles ratios(const std::vector<double> &left, const std::vector<double> &right) {
    std::vector<double> all(left.size());
    std::transform(left.begin(), left.end(), right.begin(), all.begin(), std::divides<>());
    return quartiles(all);
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
    Turns unrecorded;
    Duel duel;
    for (int turn = -warm_ups; turn < turns; ++turn) {
        Turns &left_turns = turn < 0 ? unrecorded : duel.left;
        Turns &right_turns = turn < 0 ? unrecorded : duel.right;
        if (turn % 2 == 0) {
            take_turn(left, frames, left_turns);
            take_turn(right, frames, right_turns);
        } else {
            take_turn(right, frames, right_turns);
            take_turn(left, frames, left_turns);
        }
    }
    return duel;
}

void print_duel(const Contender &left, const Contender &right, const Duel &duel, const std::string &note) {
    const auto [left_low, left_median, left_high] = quartiles(duel.left.wall);
    const auto [right_low, right_median, right_high] = quartiles(duel.right.wall);
    const auto [low, median, high] = ratios(duel.left.wall, duel.right.wall);
    const auto [cpu_low, cpu_median, cpu_high] = ratios(duel.left.cpu, duel.right.cpu);
    std::printf(
        "%-50s %7.3f ms [%.3f %.3f] | %s %.3f ms [%.3f %.3f] | ratio %.3f [%.3f %.3f], cpu %.3f [%.3f %.3f]%s\n",
        left.name.c_str(), left_median, left_low, left_high, right.name.c_str(), right_median, right_low, right_high,
        median, low, high, cpu_median, cpu_low, cpu_high, note.c_str());
    std::fflush(stdout);
}

} // namespace sandbox
