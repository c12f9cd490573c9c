#include "scene/suggest.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <vector>

namespace sandbox {
namespace {

/// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known) {
    constexpr std::size_t longest = 64; // a hostile word must not cost a hostile distance
    std::string_view nearest;
    std::size_t best = word.size() > longest ? 0 : word.size() / 3 + 2;
    for (const std::string_view candidate : known) {
        if (best == 0) {
            break;
        }
        const bool begun = word.size() >= 3 && candidate.starts_with(word); // fov for fov_y_degrees
        const std::size_t distance = begun ? 1 : edit_distance(word, candidate);
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    if (const std::string_view nearest = nearest_word(word, known); !nearest.empty()) {
        return fmt::format("; did you mean \"{}\"?", nearest);
    }
    return known.empty() ? "" : fmt::format("; expected one of {}", fmt::join(known, ", "));
}

} // namespace sandbox
