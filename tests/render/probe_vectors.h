#pragma once

#include "render/shader_probe.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace sandbox {

/// Textbook: the cosine's rounding, raised to the power n.
inline double textbook_bound(double n) { return 2e-5 + 4e-7 * n; }
/// Stable: f^n changes with the angle by sqrt(n / e) at most, and R, N x H carry an angle of 4 units in the last place.
inline double stable_bound(double n) { return 2e-6 + std::sqrt(n / std::exp(1.0)) * 4 * 0x1p-24; }

/// Seeded directions and points, and the awkward ones among them.
class Vectors {
  public:
    explicit Vectors(unsigned seed) : random_(seed) {}

    /// In [-1, 1]; by the generator's bits alone, so the same on every machine.
    float number() { return static_cast<float>(random_() >> 8) / static_cast<float>(1 << 23) - 1; }
    glm::vec3 in_cube() {
        const float x = number();
        const float y = number();
        return {x, y, number()};
    }
    glm::vec3 direction() {
        glm::vec3 v(0);
        while (glm::dot(v, v) < 1e-2F || glm::dot(v, v) > 1) {
            v = in_cube();
        }
        return glm::normalize(v);
    }

  private:
    std::mt19937 random_;
};

/// N, L, V: most near a highlight's maximum at every scale of angle, some anywhere, and the limits (L = V = N, L = -V,
/// L = -N, right angles).
inline std::vector<ProbeInput> highlight_vectors(int count, unsigned seed) {
    const glm::vec3 x(1, 0, 0);
    const glm::vec3 y(0, 1, 0);
    std::vector<ProbeInput> inputs;
    const auto add = [&](const glm::vec3 &n, const glm::vec3 &l, const glm::vec3 &v) {
        inputs.push_back({glm::vec4(n, 0), glm::vec4(l, 0), glm::vec4(v, 0)});
    };
    for (const glm::vec3 &n : {x, y, -y}) {
        for (const glm::vec3 &l : {x, -x, y, -y}) {
            add(n, l, x);
            add(n, l, -x);
            add(n, l, glm::normalize(x + y));
        }
    }
    Vectors random(seed);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 n = random.direction();
        const glm::vec3 l = random.direction();
        if (i % 4 == 0) {
            add(n, l, random.direction());
            continue;
        }
        const float spread = std::pow(10.0F, -2 + 2 * random.number()); // 1e-4 to 1
        add(n, l, glm::normalize(2 * glm::dot(n, l) * n - l + spread * random.in_cube()));
    }
    return inputs;
}

} // namespace sandbox
