#include "measure/metrics/flip_color.h"

#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace sandbox::flip {

namespace {

/// Linear sRGB to CIE XYZ, from the primaries' chromaticities (0.64, 0.33), (0.3, 0.6), (0.15, 0.06) and D65
/// (0.3127, 0.329), whole numbers over one denominator. By columns.
const glm::dmat3 xyz_of_linear = {{10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382},
                                  {8788810.0 / 24577794, 8788810.0 / 12288897, 8788810.0 / 73733382},
                                  {4435075.0 / 24577794, 887015.0 / 12288897, 70074185.0 / 73733382}};
const glm::dvec3 white = xyz_of_linear * glm::dvec3(1);

glm::dmat3 relative_to_white() {
    glm::dmat3 m = xyz_of_linear;
    for (int column = 0; column < 3; ++column) {
        m[column] /= white;
    }
    return m;
}

/// From linear sRGB to XYZ relative to white, and back.
const glm::mat3 shares_of_linear(relative_to_white());
const glm::mat3 linear_of_shares(glm::inverse(relative_to_white()));

float lab_curve(float share) {
    constexpr float delta = 6.0F / 29;
    return share > delta * delta * delta ? std::cbrt(share) : share / (3 * delta * delta) + 4.0F / 29;
}

std::array<float, 256> srgb_table() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double c = static_cast<double>(i) / 255;
        table[i] = static_cast<float>(c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92);
    }
    return table;
}

} // namespace

float linear_of(std::uint8_t byte) {
    static const std::array<float, 256> table = srgb_table();
    return table[byte];
}

glm::vec3 opponent_of(const glm::vec3 &linear) {
    const glm::vec3 s = shares_of_linear * linear;
    return {116 * s.y - 16, 500 * (s.x - s.y), 200 * (s.y - s.z)};
}

glm::vec3 linear_of_opponent(const glm::vec3 &opponent) {
    const float y = (opponent.x + 16) / 116;
    return linear_of_shares * glm::vec3(y + opponent.y / 500, y, y - opponent.z / 200);
}

glm::vec3 hunt_lab_of(const glm::vec3 &linear) {
    const glm::vec3 s = shares_of_linear * linear;
    const float x = lab_curve(s.x);
    const float y = lab_curve(s.y);
    const float z = lab_curve(s.z);
    const float lightness = 116 * y - 16;
    const float hunt = 0.01F * lightness;
    return {lightness, hunt * 500 * (x - y), hunt * 200 * (y - z)};
}

float hyab(const glm::vec3 &a, const glm::vec3 &b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

} // namespace sandbox::flip
