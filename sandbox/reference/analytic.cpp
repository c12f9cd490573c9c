#include "reference/analytic.h"

#include "reference/lighting.h"
#include "reference/quartic.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace sandbox::reference {

namespace {

constexpr double full_circle = 2 * std::numbers::pi;

/// A ray with its origin moved to where it passes nearest the object's centre: quadratics lose their linear term and
/// nothing cancels, however far away the eye is.
struct Ray {
    glm::dvec3 origin;    ///< nearest point to the centre
    glm::dvec3 direction; ///< unit
    double length;        ///< of the given direction
    double start;         ///< given t of the nearest point
    double low, high;     ///< given t

    Ray(const glm::dvec3 &from, const glm::dvec3 &along, double low_t, double high_t)
        : direction(unit(along)), length(glm::length(along)), low(low_t), high(high_t) {
        const double s = -glm::dot(from, direction);
        start = s / length;
        origin = from + s * direction;
    }
    [[nodiscard]] glm::dvec3 point(double s) const { return origin + s * direction; }
    [[nodiscard]] double t(double s) const { return start + s / length; }
    [[nodiscard]] bool within(double s) const { return t(s) >= low && t(s) <= high; }
};

/// Keeps the first of the hits offered to it.
class FirstHit {
  public:
    explicit FirstHit(const Ray &ray) : ray_(ray) {}
    [[nodiscard]] bool wants(double s) const { return ray_.within(s) && (!hit_ || ray_.t(s) < hit_->t); }
    void take(double s, const glm::dvec3 &position, const glm::dvec3 &normal, const glm::dvec2 &uv, int part = 0) {
        hit_ = ShapeHit{ray_.t(s), position, normal, uv, glm::dot(ray_.direction, normal) > 0, part};
    }
    [[nodiscard]] const std::optional<ShapeHit> &hit() const { return hit_; }

  private:
    const Ray &ray_;
    std::optional<ShapeHit> hit_;
};

/// The share of a full turn from +x towards +z, in [0, 1).
double turn(double x, double z) {
    const double share = std::atan2(z, x) / full_circle;
    return share < 0 ? share + 1 : share;
}

std::optional<ShapeHit> hit_shape(const SphereShape &sphere, const Ray &ray) {
    FirstHit first(ray);
    const double square = sphere.radius * sphere.radius - glm::dot(ray.origin, ray.origin);
    if (square < 0) {
        return {};
    }
    for (const double s : {-std::sqrt(square), std::sqrt(square)}) {
        if (first.wants(s)) {
            const glm::dvec3 n = unit(ray.point(s));
            const double down = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
            first.take(s, sphere.radius * n, n, {turn(n.x, n.z), 1 - down});
        }
    }
    return first.hit();
}

/// A flat face `normal_axis` = height of the given half sizes; right and up give u and v as they grow along the axes.
struct FlatFace {
    int normal_axis;
    double height;
    int right, up;
    double right_sign, up_sign;
};

void hit_flat(const FlatFace &face, const glm::dvec3 &size, const Ray &ray, int part, FirstHit &first) {
    const double s = (face.height - ray.origin[face.normal_axis]) / ray.direction[face.normal_axis];
    if (!std::isfinite(s) || !first.wants(s)) {
        return;
    }
    glm::dvec3 p = ray.point(s);
    p[face.normal_axis] = face.height;
    const double u = p[face.right] / size[face.right];
    const double v = p[face.up] / size[face.up];
    if (std::abs(u) <= 0.5 && std::abs(v) <= 0.5) {
        glm::dvec3 normal(0);
        normal[face.normal_axis] = part % 2 == 0 ? 1 : -1;
        first.take(s, p, normal, {0.5 + face.right_sign * u, 0.5 + face.up_sign * v}, part);
    }
}

std::optional<ShapeHit> hit_shape(const BoxShape &box, const Ray &ray) {
    FirstHit first(ray);
    const glm::dvec3 half = box.size / 2.0;
    const FlatFace faces[] = {{0, half.x, 2, 1, -1, 1}, {0, -half.x, 2, 1, 1, 1}, {1, half.y, 0, 2, 1, -1},
                              {1, -half.y, 0, 2, 1, 1}, {2, half.z, 0, 1, 1, 1},  {2, -half.z, 0, 1, -1, 1}};
    for (int part = 0; part < 6; ++part) {
        hit_flat(faces[part], box.size, ray, part, first);
    }
    return first.hit();
}

std::optional<ShapeHit> hit_shape(const PlaneShape &plane, const Ray &ray) {
    FirstHit first(ray);
    hit_flat({1, 0, 0, 2, 1, -1}, {plane.size.x, 1, plane.size.y}, ray, 0, first);
    return first.hit();
}

void hit_cap(const CylinderShape &cylinder, double sign, const Ray &ray, FirstHit &first) {
    const double y = sign * cylinder.height / 2;
    const double s = (y - ray.origin.y) / ray.direction.y;
    if (!std::isfinite(s) || !first.wants(s)) {
        return;
    }
    const glm::dvec3 p = ray.point(s);
    const double x = p.x / cylinder.radius;
    const double z = p.z / cylinder.radius;
    if (x * x + z * z <= 1) {
        first.take(s, {p.x, y, p.z}, {0, sign, 0}, {0.5 + 0.5 * x, 0.5 - 0.5 * sign * z}, sign > 0 ? 1 : 2);
    }
}

std::optional<ShapeHit> hit_shape(const CylinderShape &cylinder, const Ray &ray) {
    FirstHit first(ray);
    const glm::dvec2 o(ray.origin.x, ray.origin.z);
    const glm::dvec2 d(ray.direction.x, ray.direction.z);
    const double dd = glm::dot(d, d);
    if (dd > 0) {
        const double nearest = -glm::dot(o, d) / dd;
        const glm::dvec2 q = o + nearest * d;
        const double square = (cylinder.radius * cylinder.radius - glm::dot(q, q)) / dd;
        const double half = square >= 0 ? std::sqrt(square) : std::nan("");
        for (const double s : {nearest - half, nearest + half}) {
            const glm::dvec3 p = ray.point(s);
            if (std::abs(p.y) <= cylinder.height / 2 && first.wants(s)) {
                const glm::dvec3 n = unit({p.x, 0, p.z});
                first.take(s, cylinder.radius * n + glm::dvec3(0, p.y, 0), n,
                           {turn(n.x, n.z), 0.5 + p.y / cylinder.height});
            }
        }
    }
    if (cylinder.caps) {
        hit_cap(cylinder, 1, ray, first);
        hit_cap(cylinder, -1, ray, first);
    }
    return first.hit();
}

/// (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2), a quartic in s that has no cubic term since origin . direction = 0.
std::optional<ShapeHit> hit_shape(const TorusShape &torus, const Ray &ray) {
    FirstHit first(ray);
    const double rim = torus.radius * torus.radius;
    const double reach = torus.radius + torus.tube_radius;
    const double nearest = glm::dot(ray.origin, ray.origin);
    if (nearest > reach * reach) {
        return {};
    }
    const glm::dvec2 o(ray.origin.x, ray.origin.z);
    const glm::dvec2 d(ray.direction.x, ray.direction.z);
    const double k = nearest + rim - torus.tube_radius * torus.tube_radius;
    const double bound = std::sqrt(reach * reach - nearest) * (1 + 1e-9);
    const Roots roots = depressed_quartic_roots(2 * k - 4 * rim * glm::dot(d, d), -8 * rim * glm::dot(o, d),
                                                k * k - 4 * rim * glm::dot(o, o), bound);
    for (int i = 0; i < roots.count; ++i) {
        const double s = roots.values[static_cast<std::size_t>(i)];
        if (!first.wants(s)) {
            continue;
        }
        const glm::dvec3 p = ray.point(s);
        const glm::dvec3 out = unit({p.x, 0, p.z});
        // A spindle torus has an inner skin on the far side of the axis.
        const glm::dvec3 tube = p - torus.radius * out;
        const glm::dvec3 across = p + torus.radius * out;
        const bool inner =
            std::abs(glm::length(across) - torus.tube_radius) < std::abs(glm::length(tube) - torus.tube_radius);
        const glm::dvec3 rim_direction = inner ? -out : out;
        const glm::dvec3 n = unit(inner ? across : tube);
        first.take(s, torus.radius * rim_direction + torus.tube_radius * n, n,
                   {turn(rim_direction.x, rim_direction.z), turn(glm::dot(n, rim_direction), n.y)});
    }
    return first.hit();
}

std::optional<ShapeHit> hit_shape(const ObjShape &, const Ray &) { return {}; }

} // namespace

std::optional<ShapeHit> intersect(const Shape &shape, const glm::dvec3 &origin, const glm::dvec3 &direction, double low,
                                  double high) {
    const Ray ray(origin, direction, low, high);
    return std::visit([&](const auto &s) { return hit_shape(s, ray); }, shape);
}

} // namespace sandbox::reference
