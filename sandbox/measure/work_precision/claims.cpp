#include "measure/work_precision/claims.h"

#include <cmath>
#include <fmt/format.h>

namespace sandbox {
namespace {

std::string two_digits(double value) {
    return value >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.2g}", value);
}

std::string error_words(const Words &words, double error, double base) {
    if (!std::isfinite(error) || !std::isfinite(base)) {
        return words.text("answer.not_finite");
    }
    if (error == base) {
        return words.text("answer.equal_error");
    }
    if (base == 0 || error == 0) {
        return words.text(error == 0 ? "answer.no_error" : "answer.new_error");
    }
    const double ratio = error / base;
    return std::abs(ratio - 1) < 0.02 ? words.text("answer.same_error")
                                      : words.format("answer.times", two_digits(ratio));
}

/// A difference counts where the middle half of the rounds agrees on its sign.
std::string time_words(const Words &words, const TimeRatio &time) {
    const std::string percent = two_digits(100 * std::abs(time.median - 1));
    if (time.upper_quartile < 1) {
        return words.format("answer.less_time", percent);
    }
    return time.lower_quartile > 1 ? words.format("answer.more_time", percent) : words.text("answer.same_time");
}

} // namespace

std::vector<Claim> answer_claims(const Words &words, const WorkPrecision &measured) {
    std::vector<Claim> claims;
    const auto answer = [&](const std::string &says, const Technique &technique, const Technique &against) {
        const auto row = find_row(measured, own_mesh(measured), technique);
        const auto base = find_row(measured, own_mesh(measured), against);
        if (!row || !base || !measured.rows[*row].complete() || !measured.rows[*base].complete()) {
            return;
        }
        const auto rmse = [&](std::size_t i) { return measured.rows[i].errors->total.norms.rmse; };
        const TimeRatio time = *time_ratio(measured, *row, *base);
        const bool marked = !measured.rows[*row].mark().empty() || !measured.rows[*base].mark().empty();
        const std::string error =
            marked ? words.text("answer.too_little") : error_words(words, rmse(*row), rmse(*base));
        claims.push_back(
            {words.text(says), *row, *base, time, words.format("technique.pair", error, time_words(words, time))});
    };
    for (const Model model : richest_first(measured)) {
        const Technique per_pixel{.frequency = Frequency::per_pixel, .model = model};
        const Technique per_vertex{.frequency = Frequency::per_vertex, .model = model};
        const Technique vectors{.frequency = Frequency::interpolated_vectors, .model = model};
        const Technique hybrid{.frequency = Frequency::hybrid, .model = model};
        const auto with = [](Technique technique, auto member, auto value) {
            technique.*member = value;
            return technique;
        };
        const Technique interpolated = with(per_pixel, &Technique::attenuation, AttenuationAt::interpolated);
        const Technique distance = with(per_pixel, &Technique::attenuation, AttenuationAt::distance_interpolated);
        answer("answer.attenuation", interpolated, per_pixel);
        answer("answer.distance", distance, per_pixel);
        answer("answer.rather_distance", distance, interpolated);
        answer("answer.vectors", vectors, per_pixel);
        answer("answer.hybrid_good", hybrid, per_pixel);
        answer("answer.hybrid_better", hybrid, per_vertex);
        for (const Technique &technique : {per_pixel, per_vertex}) {
            answer("answer.viewer", with(technique, &Technique::viewer, Viewer::infinite), technique);
            answer("answer.half_vector", with(technique, &Technique::half_vector, HalfVector::constant), technique);
        }
    }
    return claims;
}

} // namespace sandbox
