#include "measure/metrics/flip.h"

#include "measure/metrics/flip_color.h"
#include "measure/metrics/flip_filters.h"
#include "reference/parallel.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>

namespace sandbox {

namespace {

using flip::Kernel;

/// The paper's constants: exponents of colour and feature differences, and where the large ones are compressed.
constexpr float color_exponent = 0.7F;
constexpr float feature_exponent = 0.5F;
constexpr float knee = 0.4F;         ///< p_c, as a share of the largest difference
constexpr float knee_height = 0.95F; ///< p_t, what the knee is mapped to

/// One channel of a picture.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    [[nodiscard]] const float *row(int y) const {
        return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
    [[nodiscard]] float *row(int y) {
        return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
};

void for_rows(int height, const std::function<void(int)> &work) {
    constexpr int piece = 16;
    parallel_for(static_cast<std::size_t>((height + piece - 1) / piece), [&](std::size_t p) {
        const int first = static_cast<int>(p) * piece;
        for (int y = first; y < std::min(first + piece, height); ++y) {
            work(y);
        }
    });
}

/// Pixels beyond the border repeat the outermost one.
Plane along_rows(const Plane &in, const Kernel &kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane out(in.width, in.height);
    for_rows(in.height, [&](int y) {
        const float *from = in.row(y);
        std::vector<float> padded(static_cast<std::size_t>(in.width + 2 * radius));
        std::fill_n(padded.begin(), radius, from[0]);
        std::copy_n(from, in.width, padded.begin() + radius);
        std::fill_n(padded.end() - radius, radius, from[in.width - 1]);
        float *to = out.row(y);
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const float weight = kernel[k];
            const float *shifted = padded.data() + k;
            for (int x = 0; x < in.width; ++x) {
                to[x] += weight * shifted[x];
            }
        }
    });
    return out;
}

Plane along_columns(const Plane &in, const Kernel &kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane out(in.width, in.height);
    for_rows(in.height, [&](int y) {
        float *to = out.row(y);
        for (int k = 0; k <= 2 * radius; ++k) {
            const float weight = kernel[static_cast<std::size_t>(k)];
            const float *from = in.row(std::clamp(y + k - radius, 0, in.height - 1));
            for (int x = 0; x < in.width; ++x) {
                to[x] += weight * from[x];
            }
        }
    });
    return out;
}

Plane filtered(const Plane &in, const flip::ContrastFilter &filter) {
    Plane sum = along_columns(along_rows(in, filter.parts[0]), filter.parts[0]);
    for (std::size_t part = 1; part < filter.parts.size(); ++part) {
        const Plane more = along_columns(along_rows(in, filter.parts[part]), filter.parts[part]);
        std::transform(sum.values.begin(), sum.values.end(), more.values.begin(), sum.values.begin(), std::plus<>());
    }
    return sum;
}

struct Opponent {
    Plane y, cx, cz;
};

Opponent opponent_of(const ByteImage &image) {
    const int width = image.size.width;
    const int height = image.size.height;
    Opponent out{{width, height}, {width, height}, {width, height}};
    for (std::size_t i = 0; i < out.y.values.size(); ++i) {
        const std::uint8_t *rgb = image.rgb.data() + 3 * i;
        const glm::vec3 c =
            flip::opponent_of({flip::linear_of(rgb[0]), flip::linear_of(rgb[1]), flip::linear_of(rgb[2])});
        out.y.values[i] = c.x;
        out.cx.values[i] = c.y;
        out.cz.values[i] = c.z;
    }
    return out;
}

/// The picture as the eye resolves it, in Hunt-adjusted CIELAB.
std::vector<glm::vec3> seen_colors(const Opponent &picture, const flip::ContrastFilters &filters) {
    const Plane y = filtered(picture.y, filters.achromatic);
    const Plane cx = filtered(picture.cx, filters.red_green);
    const Plane cz = filtered(picture.cz, filters.blue_yellow);
    std::vector<glm::vec3> out(y.values.size());
    for_rows(y.height, [&](int row) {
        const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(y.width);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(y.width); ++i) {
            const glm::vec3 linear = flip::linear_of_opponent({y.values[i], cx.values[i], cz.values[i]});
            out[i] = flip::hunt_lab_of(glm::clamp(linear, 0.0F, 1.0F));
        }
    });
    return out;
}

/// How much of an edge and of a point each pixel is.
struct Features {
    std::vector<float> edges, points;
};

std::vector<float> lengths(const Plane &x, const Plane &y) {
    std::vector<float> out(x.values.size());
    std::transform(x.values.begin(), x.values.end(), y.values.begin(), out.begin(),
                   [](float a, float b) { return std::sqrt(a * a + b * b); });
    return out;
}

Features features_of(const Plane &y, const flip::FeatureFilters &filters) {
    Plane luminance = y;
    for (float &value : luminance.values) {
        value = (value + 16) / 116;
    }
    const Plane smooth = along_rows(luminance, filters.smoothing);
    return {lengths(along_columns(along_rows(luminance, filters.edge), filters.smoothing),
                    along_columns(smooth, filters.edge)),
            lengths(along_columns(along_rows(luminance, filters.point), filters.smoothing),
                    along_columns(smooth, filters.point))};
}

/// Differences up to the knee take most of the scale; the largest possible, between green and blue, gives 1.
float redistributed(float difference) {
    static const float largest =
        std::pow(flip::hyab(flip::hunt_lab_of({0, 1, 0}), flip::hunt_lab_of({0, 0, 1})), color_exponent);
    const float bend = knee * largest;
    const float value = std::pow(difference, color_exponent);
    if (value < bend) {
        return knee_height / bend * value;
    }
    return knee_height + (value - bend) / (largest - bend) * (1 - knee_height);
}

float feature_difference(const Features &a, const Features &b, std::size_t i) {
    const float edges = std::abs(a.edges[i] - b.edges[i]);
    const float points = std::abs(a.points[i] - b.points[i]);
    return std::pow(std::max(edges, points) / std::sqrt(2.0F), feature_exponent);
}

} // namespace

std::vector<float> flip_map(const ByteImage &reference, const ByteImage &test, double pixels_per_degree) {
    if (!(reference.size == test.size)) {
        throw std::invalid_argument("flip: the pictures differ in size");
    }
    const Size size = reference.size;
    if (size.width <= 0 || size.height <= 0) {
        return {};
    }
    const flip::ContrastFilters contrast = flip::contrast_filters(pixels_per_degree);
    const flip::FeatureFilters feature = flip::feature_filters(pixels_per_degree);
    const Opponent a = opponent_of(reference);
    const Opponent b = opponent_of(test);
    const std::vector<glm::vec3> a_colors = seen_colors(a, contrast);
    const std::vector<glm::vec3> b_colors = seen_colors(b, contrast);
    const Features a_features = features_of(a.y, feature);
    const Features b_features = features_of(b.y, feature);
    std::vector<float> map(a_colors.size());
    for_rows(size.height, [&](int y) {
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(size.width); ++i) {
            const float color = redistributed(flip::hyab(a_colors[i], b_colors[i]));
            map[i] = std::pow(color, 1 - feature_difference(a_features, b_features, i));
        }
    });
    return map;
}

double mean_flip(const ByteImage &reference, const ByteImage &test, double pixels_per_degree) {
    const std::vector<float> map = flip_map(reference, test, pixels_per_degree);
    double sum = 0;
    for (const float value : map) {
        sum += static_cast<double>(value);
    }
    return map.empty() ? 0 : sum / static_cast<double>(map.size());
}

} // namespace sandbox
