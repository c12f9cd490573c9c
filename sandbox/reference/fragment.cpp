#include "reference/fragment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox::reference {

namespace {

/// a + v (b - a) + w (c - a): what is the same at all corners stays so to the last bit.
template <class T> T blend(const glm::dvec3 &weights, const T &a, const T &b, const T &c) {
    return a + weights.y * (b - a) + weights.z * (c - a);
}

template <class T> T blend(const glm::dvec3 &weights, const std::vector<T> &values, const glm::uvec3 &triangle) {
    return blend(weights, values[triangle.x], values[triangle.y], values[triangle.z]);
}

glm::dvec3 unit_or(const glm::dvec3 &v, const glm::dvec3 &otherwise) {
    const glm::dvec3 u = unit(v);
    return u == glm::dvec3(0) ? otherwise : u;
}

} // namespace

Fragment::Fragment(const MeshScene &meshes, const Hit &hit, double x, double y)
    : setup_(meshes.setup), object_(meshes.objects[hit.object - 1]), raster_(meshes.raster[hit.object - 1]),
      triangle_index_(hit.triangle), triangle_((*raster_.triangles)[hit.triangle]), x_(x), y_(y), here_(at(0, 0)) {}

glm::dvec3 Fragment::weights(double dx, double dy) const {
    const std::vector<Corner> &corners = raster_.corners;
    return weights_at(corners[triangle_.x], corners[triangle_.y], corners[triangle_.z], x_ + dx, y_ + dy);
}

Place Fragment::at(double dx, double dy) const {
    Place place;
    place.weights = weights(dx, dy);
    place.position = blend(place.weights, object_.positions, triangle_);
    place.raw_normal = blend(place.weights, object_.normals, triangle_);
    if (setup_.technique.renormalize == Renormalize::on) {
        place.normal_length = glm::length(place.raw_normal);
        place.raw_normal = unit(place.raw_normal);
    }
    if (setup_.technique.frequency == Frequency::interpolated_vectors) {
        place.view = unit(blend(place.weights, corner(0).view, corner(1).view, corner(2).view));
    } else {
        place.view = view_vector(setup_, place.position);
    }
    place.normal = facing(object_.object->two_sided, place.raw_normal, place.view);
    return place;
}

/// A corner as a place: what interpolated vectors are worked out at.
Place Fragment::corner(std::size_t i) const {
    const unsigned vertex = triangle_[static_cast<glm::length_t>(i)];
    Place place;
    place.position = object_.positions[vertex];
    place.raw_normal = object_.normals[vertex];
    place.view = view_vector(setup_, place.position);
    place.normal = place.raw_normal;
    return place;
}

LightVectors Fragment::vectors(const Place &place, std::size_t light) const {
    if (setup_.technique.frequency == Frequency::interpolated_vectors) {
        return interpolated_vectors(place, light);
    }
    const LightSetup &setup = setup_.lights[light];
    LightVectors vectors = light_vectors(setup_, setup, place.position, place.normal, place.view);
    if (setup_.technique.attenuation == AttenuationAt::exact || setup.light.type == LightType::directional) {
        return vectors;
    }
    glm::dvec3 distance(0);
    glm::dvec3 factor(0);
    for (int i = 0; i < 3; ++i) {
        distance[i] = glm::length(setup.position - object_.positions[triangle_[i]]);
        factor[i] = attenuation(setup.light.attenuation, distance[i]);
    }
    if (setup_.technique.attenuation == AttenuationAt::interpolated) {
        vectors.a = blend(place.weights, factor.x, factor.y, factor.z);
    } else {
        vectors.a = attenuation(setup.light.attenuation, blend(place.weights, distance.x, distance.y, distance.z));
    }
    return vectors;
}

LightVectors Fragment::interpolated_vectors(const Place &place, std::size_t light) const {
    const LightSetup &setup = setup_.lights[light];
    std::array<LightVectors, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
        const Place from = corner(i);
        at[i] = light_vectors(setup_, setup, from.position, from.normal, from.view);
    }
    LightVectors vectors = at[0];
    if (setup.light.type != LightType::directional) {
        vectors.l = unit_or(blend(place.weights, at[0].l, at[1].l, at[2].l), place.normal);
        vectors.d = blend(place.weights, at[0].d, at[1].d, at[2].d);
        vectors.a = setup_.technique.attenuation == AttenuationAt::interpolated
                        ? blend(place.weights, at[0].a, at[1].a, at[2].a)
                        : attenuation(setup.light.attenuation, vectors.d);
    }
    vectors.r = unit(blend(place.weights, at[0].r, at[1].r, at[2].r));
    if (setup_.technique.half_vector == HalfVector::exact) {
        vectors.h = unit_or(blend(place.weights, at[0].h, at[1].h, at[2].h), place.normal);
    }
    return vectors;
}

Reflected Fragment::reflected() const {
    const Material &material = object_.object->material;
    const auto interpolated = [&] {
        const Reflected &a = object_.lit[triangle_.x];
        const Reflected &b = object_.lit[triangle_.y];
        const Reflected &c = object_.lit[triangle_.z];
        return Reflected{blend(here_.weights, a.body, b.body, c.body),
                         blend(here_.weights, a.highlight, b.highlight, c.highlight)};
    };
    switch (setup_.technique.frequency) {
    case Frequency::flat:
        return object_.lit[triangle_index_];
    case Frequency::per_vertex:
        return interpolated();
    case Frequency::hybrid: {
        Reflected both = interpolated();
        both.highlight = reflect(setup_, material, Terms::highlight, here_, *this).highlight;
        return both;
    }
    case Frequency::per_pixel:
    case Frequency::interpolated_vectors:
        break;
    }
    return reflect(setup_, material, Terms::all, here_, *this);
}

glm::dvec3 Fragment::object_position(const glm::dvec3 &weights) const {
    return blend(weights, object_.mesh->positions, triangle_);
}

glm::dvec3 Fragment::base() const {
    const Mesh &mesh = *object_.mesh;
    const glm::dvec2 uv = mesh.uvs.empty() ? glm::dvec2(0) : blend(here_.weights, mesh.uvs, triangle_);
    return object_.base.at(uv, object_position(here_.weights));
}

glm::dvec3 Fragment::color() const { return compose(object_.object->material, base(), reflected()); }

Place Fragment::place() const {
    if (setup_.technique.frequency != Frequency::flat) {
        return here_;
    }
    const std::vector<glm::dvec3> &p = object_.positions;
    const glm::dvec3 centroid = (p[triangle_.x] + p[triangle_.y] + p[triangle_.z]) / 3.0;
    const glm::dvec3 normal = transform_normal(object_.placement.normals, face_normal(*object_.mesh, triangle_));
    return Point(setup_, object_.object->two_sided, centroid, normal).at(0, 0);
}

bool Fragment::checker_unstable() const {
    const Checker *checker = object_.base.checker;
    if (checker == nullptr || checker->colors[0] == checker->colors[1]) {
        return false;
    }
    const auto cells = [&](const glm::dvec3 &p) { return checker_coordinates(*checker, object_.base.half_extent, p); };
    const auto cells_at = [&](double dx, double dy) { return cells(object_position(weights(dx, dy))); };
    const glm::dvec3 here = cells_at(0, 0);
    const glm::dvec3 change = glm::abs(cells_at(edge_width, 0) - here) + glm::abs(cells_at(0, edge_width) - here);
    glm::dvec3 farthest(0);
    for (int i = 0; i < 3; ++i) {
        farthest = glm::max(farthest, glm::abs(cells(object_.mesh->positions[triangle_[i]]) - 0.5 * checker->cells));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double boundary = std::round(here[axis]);
        // No noise where a coordinate is 0 all over the triangle: the centre plane is exact in any precision.
        const double margin = change[axis] + 8 * 0x1p-24 * farthest[axis];
        if (boundary > 0 && boundary < checker->cells && std::abs(here[axis] - boundary) < margin) {
            return true;
        }
    }
    return false;
}

/// Where the corners' normals all but cancel, float32 rounds what is left four times as coarsely as a normal, and more.
bool Fragment::normal_unstable() const {
    const bool interpolated = setup_.technique.frequency != Frequency::flat &&
                              setup_.technique.frequency != Frequency::per_vertex &&
                              setup_.technique.renormalize == Renormalize::on;
    return interpolated && here_.normal_length < 0.25;
}

/// Vectors that are interpolated are as good as the corners'.
bool Fragment::corner_light_unstable() const {
    const auto unstable = [&](const LightSetup &light) {
        return std::ranges::any_of(
            std::array{0, 1, 2}, [&](int i) { return direction_is_rounding(light, object_.positions[triangle_[i]]); });
    };
    return setup_.technique.frequency == Frequency::interpolated_vectors &&
           std::ranges::any_of(setup_.lights, unstable);
}

bool Fragment::unstable() const {
    if (checker_unstable() || normal_unstable() || corner_light_unstable()) {
        return true;
    }
    const auto jumps = [&](Terms terms) {
        return may_jump(setup_, object_.object->material, object_.object->two_sided, terms, here_, *this);
    };
    const auto corner_unstable = [&] {
        return (object_.unstable[triangle_.x] | object_.unstable[triangle_.y] | object_.unstable[triangle_.z]) != 0;
    };
    switch (setup_.technique.frequency) {
    case Frequency::flat:
        return object_.unstable[triangle_index_] != 0;
    case Frequency::per_vertex:
        return corner_unstable();
    case Frequency::hybrid:
        return corner_unstable() || jumps(Terms::highlight);
    case Frequency::per_pixel:
    case Frequency::interpolated_vectors:
        break;
    }
    return jumps(Terms::all);
}

bool Fragment::at_edge() const {
    return near_edge(raster_.corners[triangle_.x], raster_.corners[triangle_.y], raster_.corners[triangle_.z], x_, y_);
}

} // namespace sandbox::reference
