#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace sandbox {

/// Random numbers that are the same with every standard library: an odd multiplier, then bits mixed (PCG's idea).
class StressDice {
  public:
    StressDice(std::uint32_t family, std::uint32_t seed) : state_(std::uint64_t{seed} << 32 | family) {
        next();
        next();
    }
    std::uint32_t next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        std::uint64_t x = state_;
        x ^= x >> 31;
        x *= 0x9E3779B97F4A7C15ULL;
        return static_cast<std::uint32_t>(x >> 32);
    }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(std::uint64_t{next()} * count >> 32); }
    double between(double low, double high) { return low + (high - low) * (next() / 4294967296.0); }
    double power_of_ten(double low, double high) { return std::pow(10, between(low, high)); }
    bool chance(double share) { return between(0, 1) < share; }
    double sign() { return chance(0.5) ? -1 : 1; }
    template <class T, std::size_t N> T one_of(const T (&values)[N]) {
        return values[below(static_cast<std::uint32_t>(N))];
    }
    glm::dvec3 vector(double low, double high) {
        const double x = between(low, high);
        const double y = between(low, high);
        return {x, y, between(low, high)};
    }
    glm::dvec3 direction() {
        while (true) {
            const glm::dvec3 v = vector(-1, 1);
            if (const double length = glm::length(v); length > 0.1 && length < 1) {
                return v / length;
            }
        }
    }

  private:
    std::uint64_t state_;
};

} // namespace sandbox
