#include "image/difference.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace sandbox {
namespace {

constexpr float darkest_outline = 0.25F;
constexpr float outline_gain = 3; // an edge of a third of the range is as dark as outlines get

bool finite(const glm::vec4 &p) { return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b); }

/// About as bright as eyes see it, [0, 1]; 0 where it is not finite.
float lightness(const glm::vec4 &p) {
    const float luminance = glm::dot(glm::vec3(p), glm::vec3(0.2126F, 0.7152F, 0.0722F));
    return finite(p) ? std::sqrt(std::clamp(luminance, 0.0F, 1.0F)) : 0.0F;
}

/// How dark the outline is: larger where the picture's lightness changes within two pixels.
float outline(const Image &picture, int x, int y) {
    const auto at = [&](int i, int j) {
        return lightness(
            picture.at(std::clamp(i, 0, picture.size.width - 1), std::clamp(j, 0, picture.size.height - 1)));
    };
    const float change = std::abs(at(x + 1, y) - at(x - 1, y)) + std::abs(at(x, y + 1) - at(x, y - 1));
    return darkest_outline * std::min(1.0F, outline_gain * change);
}

float largest_channel(const glm::vec3 &d) {
    const glm::vec3 size = glm::abs(d);
    return size.r >= size.g && size.r >= size.b ? d.r : size.g >= size.b ? d.g : d.b;
}

} // namespace

glm::vec3 difference_color(float value) {
    const float t = std::clamp(value, -1.0F, 1.0F);
    const glm::vec3 end = t > 0 ? glm::vec3(0.85F, 0.37F, 0.01F) : glm::vec3(0.13F, 0.35F, 0.75F);
    return glm::mix(glm::vec3(1), end, std::abs(t));
}

ByteImage difference_picture(const Image &first, const Image &second, double gain) {
    ByteImage picture{first.size, {}};
    picture.rgb.reserve(3 * first.pixels.size());
    for (int y = 0; y < first.size.height; ++y) {
        for (int x = 0; x < first.size.width; ++x) {
            const glm::vec4 &a = first.at(x, y), &b = second.at(x, y);
            const float value = static_cast<float>(gain) * largest_channel(glm::vec3(a) - glm::vec3(b));
            const glm::vec3 color =
                finite(a) && finite(b) ? difference_color(value) * (1 - outline(first, x, y)) : glm::vec3(1, 0, 1);
            for (int channel = 0; channel < 3; ++channel) {
                picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * color[channel])));
            }
        }
    }
    return picture;
}

double largest_difference(const Image &first, const Image &second) {
    double largest = 0;
    for (std::size_t i = 0; i < std::min(first.pixels.size(), second.pixels.size()); ++i) {
        const glm::dvec3 apart = glm::abs(glm::dvec3(first.pixels[i]) - glm::dvec3(second.pixels[i]));
        const double most = apart.r + apart.g + apart.b; // NaN if one of them is; std::max would lose it
        largest = std::isfinite(most) ? std::max({largest, apart.r, apart.g, apart.b})
                                      : std::numeric_limits<double>::infinity();
    }
    return largest;
}

} // namespace sandbox
