#include "measure/work_precision/claims.h"

#include <cmath>
#include <fmt/format.h>

namespace sandbox {
namespace {

std::string two_digits(double value) {
    return value >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.2g}", value);
}

std::string error_words(double error, double base) {
    if (!std::isfinite(error) || !std::isfinite(base)) {
        return "a picture that is not finite";
    }
    if (error == base) {
        return "the same error";
    }
    if (base == 0 || error == 0) {
        return error == 0 ? "no error at all" : "an error where there was none";
    }
    const double ratio = error / base;
    return std::abs(ratio - 1) < 0.02 ? "the same error within 2 %" : two_digits(ratio) + " times the error";
}

/// A difference counts where the middle half of the rounds agrees on its sign.
std::string time_words(const TimeRatio &time) {
    const std::string percent = two_digits(100 * std::abs(time.median - 1)) + " %";
    if (time.upper_quartile < 1) {
        return percent + " less time";
    }
    return time.lower_quartile > 1 ? percent + " more time" : "no measurable difference in time";
}

} // namespace

std::vector<Claim> answer_claims(const WorkPrecision &measured) {
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
        const std::string error = marked ? "too little is compared to say" : error_words(rmse(*row), rmse(*base));
        claims.push_back({says, *row, *base, time, error + ", " + time_words(time)});
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
        answer("Attenuation may be interpolated", interpolated, per_pixel);
        answer("The distance may be interpolated", distance, per_pixel);
        answer("Interpolate the distance rather than attenuation", distance, interpolated);
        answer("The light vectors may be interpolated", vectors, per_pixel);
        answer("Hybrid is nearly as good as per-pixel", hybrid, per_pixel);
        answer("Hybrid is better than per-vertex", hybrid, per_vertex);
        for (const Technique &technique : {per_pixel, per_vertex}) {
            answer("The viewer may be infinitely far away", with(technique, &Technique::viewer, Viewer::infinite),
                   technique);
            answer("One half vector a light is enough", with(technique, &Technique::half_vector, HalfVector::constant),
                   technique);
        }
    }
    return claims;
}

} // namespace sandbox
