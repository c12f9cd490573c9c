#include "measure/metrics/flip_filters.h"

#include <cmath>
#include <numbers>

namespace sandbox::flip {

namespace {

constexpr double pi = std::numbers::pi;

/// a sqrt(pi / b) exp(-pi^2 x^2 / b)
struct Gaussian {
    double a, b;
};

/// Table 1 of the paper: contrast sensitivity functions, in cycles a degree, fitted by one or two Gaussians.
constexpr Gaussian achromatic[] = {{1, 0.0047}};
constexpr Gaussian red_green[] = {{1, 0.0053}};
constexpr Gaussian blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double widest_b = 0.04;

/// Twice the standard deviation of the eye's edge detector, in degrees.
constexpr double feature_width = 0.082;

template <std::size_t N> ContrastFilter contrast_filter(const Gaussian (&gaussians)[N], double ppd) {
    // Three standard deviations of the widest Gaussian, for all channels alike.
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest_b / (2 * pi * pi)) * ppd));
    std::vector<std::vector<double>> parts;
    double total = 0;
    for (const Gaussian &g : gaussians) {
        std::vector<double> part;
        double sum = 0;
        for (int i = -radius; i <= radius; ++i) {
            const double x = i / ppd;
            // The root of the 2D weight at the centre: rows times columns give it back.
            part.push_back(std::sqrt(g.a * std::sqrt(pi / g.b)) * std::exp(-pi * pi * x * x / g.b));
            sum += part.back();
        }
        total += sum * sum;
        parts.push_back(part);
    }
    ContrastFilter filter;
    for (const std::vector<double> &part : parts) {
        Kernel kernel;
        for (const double weight : part) {
            kernel.push_back(static_cast<float>(weight / std::sqrt(total)));
        }
        filter.parts.push_back(kernel);
    }
    return filter;
}

/// Positive weights scaled to sum to 1, negative ones to -1.
Kernel balanced(const std::vector<double> &weights) {
    double positive = 0;
    double negative = 0;
    for (const double w : weights) {
        (w > 0 ? positive : negative) += std::abs(w);
    }
    Kernel kernel;
    for (const double w : weights) {
        kernel.push_back(static_cast<float>(w > 0 ? w / positive : (w < 0 ? w / negative : 0)));
    }
    return kernel;
}

} // namespace

ContrastFilters contrast_filters(double ppd) {
    return {contrast_filter(achromatic, ppd), contrast_filter(red_green, ppd), contrast_filter(blue_yellow, ppd)};
}

FeatureFilters feature_filters(double ppd) {
    const double deviation = 0.5 * feature_width * ppd;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    std::vector<double> smoothing;
    std::vector<double> edge;
    std::vector<double> point;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / deviation;
        const double g = std::exp(-x * x / 2);
        smoothing.push_back(g);
        edge.push_back(-x * g);
        point.push_back((x * x - 1) * g);
    }
    return {balanced(smoothing), balanced(edge), balanced(point)};
}

} // namespace sandbox::flip
