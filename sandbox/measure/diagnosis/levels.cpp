#include "measure/diagnosis/levels.h"

#include "image/error.h"
#include "image/image_file.h"
#include "image/srgb.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandbox {
namespace {

constexpr double gamma = 2.2;

} // namespace

Observed decode_observed(std::string_view bytes, const std::string &name) {
    if (bytes.starts_with(png_signature)) {
        return {decode_png(bytes, name), true};
    }
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) {
        return {decode_pfm(bytes, name), false};
    }
    throw InputError("{}: expected a PNG or PFM picture, got {}", name,
                     bytes.empty() ? "an empty file" : "another kind of file");
}

double encoded(double linear, Encoding encoding) {
    switch (encoding) {
    case Encoding::srgb:
        return srgb_curve(linear);
    case Encoding::gamma:
        return linear <= 0 ? 0 : std::pow(linear, 1 / gamma);
    default:
        return linear;
    }
}

double decoded(double number, Encoding encoding) {
    switch (encoding) {
    case Encoding::srgb:
        return inverse_srgb_curve(number);
    case Encoding::gamma:
        return number <= 0 ? 0 : std::pow(number, gamma);
    default:
        return number;
    }
}

Levels observed_levels(const Observed &observed, const Reading &reading) {
    const Image &image = observed.numbers;
    Levels levels;
    levels.reserve(3 * image.pixels.size());
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            const glm::vec4 &pixel = image.at(x, reading.flipped ? image.size.height - 1 - y : y);
            for (int c = 0; c < 3; ++c) {
                const float level = 255 * pixel[c];
                levels.push_back(observed.bytes ? std::round(level) : level);
            }
        }
    }
    return levels;
}

Levels shown_levels(const Image &drawn, const Reading &reading, bool bytes) {
    Levels levels;
    levels.reserve(3 * drawn.pixels.size());
    for (const glm::vec4 &pixel : drawn.pixels) {
        for (int c = 0; c < 3; ++c) {
            if (!std::isfinite(pixel[c])) {
                levels.push_back(std::numeric_limits<float>::infinity());
                continue;
            }
            const double light = bytes || reading.clamped ? std::clamp(static_cast<double>(pixel[c]), 0.0, 1.0)
                                                          : static_cast<double>(pixel[c]);
            const double level = 255 * encoded(light, reading.encoding);
            levels.push_back(static_cast<float>(bytes ? std::round(level) : level));
        }
    }
    return levels;
}

Difference difference_of(const Levels &a, const Levels &b, const std::vector<std::uint8_t> &compared, double limit) {
    constexpr double most = 16;
    Difference difference;
    double squares = 0;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        if (compared[i] == 0) {
            continue;
        }
        double here = 0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double by = std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c]));
            // Infinity less infinity is no number, and no agreement.
            here = std::isnan(by) ? std::numeric_limits<double>::infinity() : std::max(here, by);
            const double cut = by <= most ? by : most;
            squares += cut * cut;
        }
        if (here > difference.largest) {
            difference.largest = here;
            difference.pixel = i;
        }
        difference.over += here > limit ? 1 : 0;
        ++difference.compared;
    }
    if (difference.compared > 0) {
        difference.rms = std::sqrt(squares / (3 * static_cast<double>(difference.compared)));
    }
    return difference;
}

} // namespace sandbox
