#include "reference/surface.h"

#include "scene/space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox::reference {

namespace {

double largest_entry(const glm::dmat3 &m) {
    double largest = 0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            largest = std::max(largest, std::abs(m[column][row]));
        }
    }
    return largest;
}

/// The texel at column i and row j counted from the bottom, repeated.
glm::dvec3 texel(const Image &image, double i, double j) {
    const double width = image.size.width;
    const double height = image.size.height;
    const int x = static_cast<int>(i - std::floor(i / width) * width);
    const int y = static_cast<int>(j - std::floor(j / height) * height);
    return glm::dvec3(
        image.at(std::min(x, image.size.width - 1), image.size.height - 1 - std::min(y, image.size.height - 1)));
}

} // namespace

glm::dmat3 normal_matrix(const glm::dmat3 &linear, Normals normals) {
    const double largest = largest_entry(linear);
    if (normals == Normals::unnormalized) {
        return linear;
    }
    if (normals == Normals::untransformed || largest == 0) {
        return glm::dmat3(1);
    }
    const glm::dmat3 a = linear / largest;
    if (normals == Normals::model_matrix && !scales_evenly(a)) {
        return a; // otherwise it is the normal matrix, but for rounding, which must not look like a fault
    }
    const glm::dmat3 cofactor(glm::cross(a[1], a[2]), glm::cross(a[2], a[0]), glm::cross(a[0], a[1]));
    return normals != Normals::cofactor && glm::dot(a[0], cofactor[0]) < 0 ? -cofactor : cofactor;
}

glm::dvec3 transform_normal(const glm::dmat3 &matrix, const glm::dvec3 &n) {
    const glm::dvec3 transformed = unit(matrix * n);
    return transformed == glm::dvec3(0) ? n : transformed;
}

WorldTransform world_transform(const Transform &transform, const Setup &setup) {
    WorldTransform to_world;
    to_world.linear = linear_part(transform);
    to_world.offset = transform.translate - setup.eye;
    to_world.lit_offset = setup.technique.position == LightingPosition::w0 ? -setup.eye : to_world.offset;
    // Without a scale nothing but rounding tells unnormalized normals from unit ones: it must not look like a fault.
    to_world.unnormalized =
        setup.technique.normals == Normals::unnormalized && glm::abs(transform.scale) != glm::dvec3(1);
    const bool unit = setup.technique.normals == Normals::unnormalized && !to_world.unnormalized;
    to_world.normals = normal_matrix(to_world.linear, unit ? Normals::inverse_transpose : setup.technique.normals);
    if (setup.technique.normals == Normals::view_space) {
        to_world.normals = setup.to_view * to_world.normals;
    }
    to_world.absolute = setup.technique.position == LightingPosition::absolute;
    to_world.translate = transform.translate;
    to_world.eye = setup.eye;
    return to_world;
}

glm::dvec3 sample_texture(const Image &image, const glm::dvec2 &uv) {
    const double x = uv.x * image.size.width - 0.5;
    const double y = uv.y * image.size.height - 0.5;
    const double i = std::floor(x);
    const double j = std::floor(y);
    const glm::dvec3 below = glm::mix(texel(image, i, j), texel(image, i + 1, j), x - i);
    const glm::dvec3 above = glm::mix(texel(image, i, j + 1), texel(image, i + 1, j + 1), x - i);
    return glm::mix(below, above, y - j);
}

glm::dvec3 checker_coordinates(const Checker &checker, double half_extent, const glm::dvec3 &p) {
    const double scale = half_extent > 0 ? checker.cells / (2 * half_extent) : 0;
    return p * scale + 0.5 * checker.cells;
}

glm::dvec3 checker_color(const Checker &checker, double half_extent, const glm::dvec3 &p) {
    const glm::dvec3 cell =
        glm::clamp(glm::floor(checker_coordinates(checker, half_extent, p)), 0.0, checker.cells - 1.0);
    const double sum = cell.x + cell.y + cell.z;
    return checker.colors[std::fmod(sum, 2) == 0 ? 0 : 1];
}

glm::dvec3 BaseColor::color_at(const glm::dvec2 &uv, const glm::dvec3 &object_position) const {
    if (texture != nullptr) {
        return sample_texture(*texture, uv);
    }
    return checker != nullptr ? checker_color(*checker, half_extent, object_position) : glm::dvec3(1);
}

bool BaseColor::has_cells() const { return checker != nullptr && checker->colors[0] != checker->colors[1]; }

bool BaseColor::cell_may_change(const glm::dvec3 &here, const glm::dvec3 &right, const glm::dvec3 &below,
                                const glm::dvec3 &rounding) const {
    const auto cells = [&](const glm::dvec3 &p) { return checker_coordinates(*checker, half_extent, p); };
    const glm::dvec3 cell = cells(here);
    const glm::dvec3 margin = glm::abs(cells(right) - cell) + glm::abs(cells(below) - cell) + rounding;
    for (int axis = 0; axis < 3; ++axis) {
        const double boundary = std::round(cell[axis]);
        if (boundary > 0 && boundary < checker->cells && std::abs(cell[axis] - boundary) < margin[axis]) {
            return true;
        }
    }
    return false;
}

BaseColor base_color(const Object &object, const ObjectResources &resources) {
    BaseColor base;
    base.texture = resources.texture.get();
    base.checker = object.material.checker ? &*object.material.checker : nullptr;
    base.half_extent = base.checker != nullptr ? half_extent(*resources.mesh) : 1;
    return base;
}

} // namespace sandbox::reference
