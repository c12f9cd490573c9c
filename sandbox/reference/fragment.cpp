#include "reference/fragment.h"

#include "scene/light_kind.h"
#include "scene/space.h"
#include "scene/unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox::reference {

namespace {

/// A corner's vector is made unit again with the others': it may turn the sum by this many times its weight.
constexpr double corner_weight = 10;

/// a + v (b - a) + w (c - a): a value that all corners share comes out exactly.
template <class T> T blend(const glm::dvec3 &weights, const T &a, const T &b, const T &c) {
    return a + weights.y * (b - a) + weights.z * (c - a);
}

template <class T> T blend(const glm::dvec3 &weights, const std::vector<T> &values, const glm::uvec3 &triangle) {
    return blend(weights, values[triangle.x], values[triangle.y], values[triangle.z]);
}

Side side_of(const Object &object, const Triangle &on_screen) {
    return orientation(on_screen) == (is_mirrored(object.transform) ? -1 : 1) ? Side::back : Side::front;
}

} // namespace

Fragment::Fragment(const MeshScene &scene, const Hit &hit, double x, double y)
    : Sampler(scene.objects[hit.object - 1].setup, *scene.objects[hit.object - 1].object),
      mesh_(scene.objects[hit.object - 1]), on_screen_(scene.raster[hit.object - 1].triangle(hit.triangle)),
      triangle_index_(hit.triangle), frequency_(mesh_.frequency(hit.triangle)),
      triangle_(mesh_.mesh->triangles[hit.triangle]), side_(side_of(*mesh_.object, on_screen_)),
      lit_(mesh_.object->two_sided && side_ == Side::back ? mesh_.back : mesh_.front), x_(x), y_(y),
      here_(point_at(0, 0)) {}

glm::dvec3 Fragment::weights(double dx, double dy) const { return weights_at(on_screen_, x_ + dx, y_ + dy); }

SurfacePoint Fragment::point_at(double dx, double dy) const {
    SurfacePoint point;
    point.weights = weights(dx, dy);
    point.position = blend(point.weights, mesh_.positions, triangle_);
    point.raw_normal = blend(point.weights, mesh_.normals, triangle_);
    if (keeps_normal_lengths()) {
        point.normal_length = 1 / std::max(glm::length(point.raw_normal), 1e-300);
    } else if (setup_.technique.renormalize == Renormalize::on) {
        point.normal_length = glm::length(point.raw_normal);
        point.raw_normal = unit(point.raw_normal);
    }
    if (frequency_ == Frequency::interpolated_vectors) {
        point.view = blend(point.weights, corner(0).view, corner(1).view, corner(2).view);
        point.view_length = glm::length(point.view);
        point.view = unit(point.view);
    } else {
        point.view = view_vector(setup_, point.position);
    }
    point.normal = facing(setup_, object_.two_sided, point.raw_normal, point.view, side_);
    return point;
}

InterpolationTerms Fragment::interpolation_terms() const {
    double farthest = 0;
    for (int i = 0; i < 3; ++i) {
        farthest = std::max(farthest, glm::distance(here_.position, mesh_.positions[triangle_[i]]));
    }
    const double weights = weights_before_cancelling(on_screen_, x_, y_);
    return {weights, weights * farthest};
}

/// Where interpolated vectors are computed: N is not turned there.
SurfacePoint Fragment::corner(int i) const {
    const glm::dvec3 &position = mesh_.positions[triangle_[i]];
    const glm::dvec3 &normal = mesh_.normals[triangle_[i]];
    return {.position = position, .raw_normal = normal, .normal = normal, .view = view_vector(setup_, position)};
}

LightVectors Fragment::vectors(const SurfacePoint &point, std::size_t light) const {
    if (frequency_ == Frequency::interpolated_vectors) {
        return interpolated_vectors(point, light);
    }
    const LightSetup &setup = setup_.lights[light];
    LightVectors vectors = Sampler::vectors(point, light);
    if (setup_.technique.attenuation == AttenuationAt::exact || !has_position(setup.light)) {
        return vectors;
    }
    const auto distance = [&](int i) { return glm::length(setup.position - mesh_.positions[triangle_[i]]); };
    const auto factor = [&](int i) { return attenuation(setup.light.attenuation, distance(i)); };
    vectors.a = setup_.technique.attenuation == AttenuationAt::interpolated
                    ? blend(point.weights, factor(0), factor(1), factor(2))
                    : attenuation(setup.light.attenuation, blend(point.weights, distance(0), distance(1), distance(2)));
    return vectors;
}

LightVectors Fragment::blended_vectors(const SurfacePoint &point, std::size_t light) const {
    const auto at_corner = [&](int i) { return Sampler::vectors(corner(i), light); };
    const std::array<LightVectors, 3> corners{at_corner(0), at_corner(1), at_corner(2)};
    LightVectors vectors = corners[0];
    const auto interpolate = [&](auto member) {
        vectors.*member = blend(point.weights, corners[0].*member, corners[1].*member, corners[2].*member);
    };
    interpolate(&LightVectors::l);
    interpolate(&LightVectors::d);
    interpolate(&LightVectors::a);
    interpolate(&LightVectors::r);
    interpolate(&LightVectors::h);
    return vectors;
}

LightVectors Fragment::interpolated_vectors(const SurfacePoint &point, std::size_t light) const {
    const LightSetup &setup = setup_.lights[light];
    LightVectors vectors = blended_vectors(point, light);
    if (has_position(setup.light)) {
        vectors.l_length = glm::length(vectors.l);
        vectors.l = unit_or(vectors.l, point.normal);
        if (setup_.technique.attenuation != AttenuationAt::interpolated) {
            vectors.a = attenuation(setup.light.attenuation, vectors.d);
        }
    }
    if (setup_.technique.model == Model::phong) {
        vectors.highlight_length = std::min(glm::length(vectors.r), point.view_length);
        vectors.r = unit(vectors.r);
    } else if (setup_.technique.half_vector == HalfVector::exact) {
        vectors.highlight_length = glm::length(vectors.h);
        vectors.h = unit_or(vectors.h, point.normal);
    }
    return vectors;
}

/// v_distance and v_attenuation are written for every technique that may read them.
Varyings Fragment::varyings() const {
    const Technique &technique = setup_.technique;
    const Mesh &mesh = *mesh_.mesh;
    const bool unit = technique.renormalize == Renormalize::on && technique.normals != Normals::unnormalized;
    Varyings varyings{.position = here_.position - setup_.origin,
                      .normal = here_.raw_normal * (unit ? here_.normal_length : 1),
                      .view = here_.view * here_.view_length,
                      .light = {},
                      .vectors = {},
                      .uv = mesh.uvs.empty() ? glm::dvec2(0) : blend(here_.weights, mesh.uvs, triangle_),
                      .object_position = object_position(here_.weights),
                      .color = mesh.colors.empty() ? glm::dvec3(1) : blend(here_.weights, mesh.colors, triangle_),
                      .colored = !mesh.colors.empty(),
                      .side = side_};
    if (frequency_ == Frequency::hybrid) {
        varyings.light = interpolated_light(&Reflected::body);
    }
    if (frequency_ == Frequency::interpolated_vectors || technique.attenuation != AttenuationAt::exact) {
        for (std::size_t i = 0; i < setup_.lights.size(); ++i) {
            varyings.vectors.push_back(blended_vectors(here_, i));
        }
    }
    return varyings;
}

glm::dvec3 Fragment::interpolated_light(glm::dvec3 Reflected::*part) const {
    const std::vector<Reflected> &light = lit_.light;
    return blend(here_.weights, light[triangle_.x].*part, light[triangle_.y].*part, light[triangle_.z].*part);
}

Reflected Fragment::reflected() const {
    switch (frequency_) {
    case Frequency::flat:
        return lit_.light[triangle_index_];
    case Frequency::per_vertex:
        return {interpolated_light(&Reflected::body), interpolated_light(&Reflected::highlight)};
    case Frequency::hybrid:
        return {interpolated_light(&Reflected::body), reflect(Terms::highlight, here_).highlight};
    case Frequency::per_pixel:
    case Frequency::interpolated_vectors:
    case Frequency::automatic: // chosen: see frequency_
        break;
    }
    return reflect(Terms::all, here_);
}

glm::dvec3 Fragment::object_position(const glm::dvec3 &weights) const {
    return blend(weights, mesh_.mesh->positions, triangle_);
}

glm::dvec3 Fragment::base() const {
    const Mesh &mesh = *mesh_.mesh;
    const glm::dvec2 uv = mesh.uvs.empty() ? glm::dvec2(0) : blend(here_.weights, mesh.uvs, triangle_);
    const glm::dvec3 color = mesh_.base.color_at(uv, object_position(here_.weights));
    return mesh.colors.empty() ? color : color * blend(here_.weights, mesh.colors, triangle_);
}

glm::dvec3 Fragment::color() const {
    return setup_.technique.precision == Precision::medium ? medium_color(setup_, object_, mesh_.base, varyings())
                                                           : compose(object_.material, base(), reflected());
}

SurfacePoint Fragment::evaluated_point() const {
    const bool flat = frequency_ == Frequency::flat;
    return flat ? centroid(setup_, mesh_, triangle_, side_).point_at(0, 0) : here_;
}

bool Fragment::at_cell_border() const {
    if (!mesh_.base.has_cells()) {
        return false;
    }
    const auto position = [&](double dx, double dy) { return object_position(weights(dx, dy)); };
    const Checker &checker = *mesh_.base.checker;
    glm::dvec3 farthest(0); // no rounding where a coordinate is 0 all over the triangle: the centre plane is exact
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &corner = mesh_.mesh->positions[triangle_[i]];
        const glm::dvec3 cell = checker_coordinates(checker, mesh_.base.half_extent, corner);
        farthest = glm::max(farthest, glm::abs(cell - 0.5 * checker.cells));
    }
    return mesh_.base.cell_may_change(position(0, 0), position(edge_width, 0), position(0, edge_width),
                                      rounding * farthest);
}

/// Interpolated vectors are only as reliable as the corners': L lies in a ball, and so does R or H.
Doubts Fragment::corner_doubts() const {
    Doubts doubts;
    for (std::size_t i = 0; i < setup_.lights.size(); ++i) {
        glm::dvec3 to_light(0), highlight(0);
        double radius = 0, lost = 0;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 &position = mesh_.positions[triangle_[k]];
            const double weight = std::max(here_.weights[k], 0.0);
            const LightVectors vectors = Sampler::vectors(corner(k), i);
            if (direction_is_rounding(setup_, setup_.lights[i], position)) {
                const LostDirection left = lost_direction(setup_, setup_.lights[i], position);
                to_light += weight * left.length * vectors.l;
                radius += weight * left.radius;
                lost += weight;
            } else {
                to_light += weight * vectors.l;
                highlight += weight * (setup_.technique.model == Model::phong ? vectors.r : vectors.h);
            }
        }
        if (lost > 0) {
            const Reflected doubt = doubt_of_direction(Terms::all, here_, i, directions_to(to_light, radius),
                                                       directions_to(highlight, lost));
            doubts += std::min(lost * corner_weight, 1.0) * Doubts{{}, doubt};
        }
    }
    return doubts;
}

Doubts Fragment::doubts() const {
    const auto interpolated = [&] {
        Doubts sum;
        for (int k = 0; k < 3; ++k) {
            sum += std::max(here_.weights[k], 0.0) * lit_.doubts[triangle_[k]];
        }
        return sum;
    };
    switch (frequency_) {
    case Frequency::flat:
        return lit_.doubts[triangle_index_];
    case Frequency::per_vertex:
        return interpolated();
    case Frequency::hybrid: {
        Doubts sum = interpolated();
        return sum += Sampler::doubts(Terms::highlight, here_);
    }
    case Frequency::interpolated_vectors: {
        Doubts sum = corner_doubts();
        return sum += Sampler::doubts(Terms::all, here_);
    }
    case Frequency::per_pixel:
    case Frequency::automatic: // chosen: see frequency_
        break;
    }
    return Sampler::doubts(Terms::all, here_);
}

PixelMasks Fragment::masks() const {
    return at_cell_border() ? border_masks(doubts(), *mesh_.base.checker, reflected())
                            : Sampler::masks(doubts(), base());
}

bool Fragment::at_edge() const { return near_edge(on_screen_, x_, y_); }

} // namespace sandbox::reference
