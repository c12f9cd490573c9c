#include "shading/normal_matrix.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

double largest_element(const glm::dmat3 &m) {
    double largest = 0;
    for (int i = 0; i < 9; ++i) {
        largest = std::max(largest, std::abs(m[i / 3][i % 3]));
    }
    return largest;
}

} // namespace

glm::dmat3 normal_matrix(const glm::dmat3 &linear) {
    const double scale = largest_element(linear);
    if (scale == 0) {
        return glm::dmat3(1);
    }
    const glm::dmat3 m = linear / scale; // products of elements neither overflow nor vanish
    const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double sign = glm::dot(m[0], cofactor[0]) < 0 ? -1 : 1;
    const double largest = largest_element(cofactor);
    return largest > 0 ? cofactor * (sign / largest) : m;
}

} // namespace sandbox
