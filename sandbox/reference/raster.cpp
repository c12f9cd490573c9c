#include "reference/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace sandbox::reference {

namespace {

constexpr int band_rows = 16;

/// Two depths closer than this, in OpenGL's depth range [0, 1], may come out in either order: a float32 depth buffer
/// resolves 6e-8 near 1, and the interpolated depth, or its logarithm, carries a few such steps.
constexpr double depth_resolution = 4e-7;
constexpr double interpolation = 0x1p-22; ///< four roundings

/// The edge function from p to q at the origin of shifted corners: positive on one side, and exactly the negative where
/// p and q are exchanged, so that two triangles which share an edge agree on every pixel.
double edge(const Corner &p, const Corner &q) { return p.x * q.y - q.x * p.y; }

/// The triangle seen from (x, y) as the origin.
Triangle shifted(Triangle triangle, double x, double y) {
    for (Corner &corner : triangle) {
        corner = {corner.x - corner.z * x, corner.y - corner.z * y, corner.z};
    }
    return triangle;
}

/// How the edge function from p to q grows per pixel to the right (x) and down (y).
glm::dvec2 slope(const Corner &p, const Corner &q) { return {p.y * q.z - q.y * p.z, p.z * q.x - q.z * p.x}; }

/// Does a centre exactly on this edge belong to the triangle on its positive side? Left edges and top edges own it.
bool owns(const glm::dvec2 &slope) { return slope.x > 0 || (slope.x == 0 && slope.y > 0); }

/// The edges opposite each corner, turned so that the inside is positive.
struct Edges {
    double sign = 0; ///< 0: the triangle is seen edge-on
    std::array<bool, 3> owned{};
    std::array<double, 3> reach{};  ///< the edge function's growth over edge_width
    double lowest = 0, highest = 0; ///< 1 / w over the corners, where all lie in front

    /// `nearness`: 1, or the corners' own.
    Edges(const Triangle &t, const glm::dvec3 &nearness) {
        const auto &[a, b, c] = t;
        sign = orientation(t);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 growth = sign * slope(t[(i + 1) % 3], t[(i + 2) % 3]);
            owned[i] = owns(growth);
            reach[i] = std::hypot(growth.x, growth.y) * edge_width;
        }
        const bool front = a.z > 0 && b.z > 0 && c.z > 0;
        const glm::dvec3 n = nearness / glm::dvec3(a.z, b.z, c.z);
        lowest = front ? std::min({n.x, n.y, n.z}) : 0;
        highest = front ? std::max({n.x, n.y, n.z}) : std::numeric_limits<double>::infinity();
    }
};

void keep_nearer(Hit &kept, Hit drawn) {
    const double lead = drawn.inverse_w - kept.inverse_w;
    const bool tie = kept.object != 0 && std::abs(lead) < std::max(kept.resolution, drawn.resolution);
    if (lead > 0) {
        drawn.beside = kept.beside;
        drawn.tie = tie;
        drawn.own_tie = tie && (kept.object == drawn.object || kept.tie); // what `kept` met may lie within, too
        kept = drawn;
    } else {
        kept.tie = kept.tie || tie;
        kept.own_tie = kept.own_tie || (tie && kept.object == drawn.object);
    }
}

glm::dvec3 areas_at(const Triangle &triangle, double x, double y) {
    const auto [p, q, r] = shifted(triangle, x, y);
    return {edge(q, r), edge(r, p), edge(p, q)};
}

} // namespace

Triangle RasterObject::triangle(std::size_t index) const {
    const glm::uvec3 &t = (*triangles)[index];
    Triangle triangle{corners[t.x], corners[t.y], corners[t.z]};
    const auto is_whole = [&](unsigned vertex) {
        return nearness.empty() ? corners[vertex].z >= near && corners[vertex].z <= far
                                : nearness[vertex] >= 0 && nearness[vertex] <= 1;
    };
    if (window_grid > 0 && is_whole(t.x) && is_whole(t.y) && is_whole(t.z)) {
        for (Corner &corner : triangle) {
            const double step = corner.z / window_grid;
            corner.x = std::round(corner.x / step) * step;
            corner.y = std::round(corner.y / step) * step;
        }
    }
    return triangle;
}

double orientation(const Triangle &t) {
    const auto &[a, b, c] = t;
    const Triangle s = a.z != 0 ? shifted(t, a.x / a.z, a.y / a.z) : t;
    const double volume = edge(s[1], s[2]) * a.z + edge(s[2], s[0]) * b.z + edge(s[0], s[1]) * c.z;
    return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
}

double DepthRange::resolution(double inverse_w, double highest) const {
    // The logarithm's step is a share of the distance, but 1 / w is rounded as it is interpolated from the nearest
    // corner.
    return deep ? depth_resolution * std::log(far / near) * inverse_w + interpolation * std::min(highest, nearest())
                : depth_resolution * nearest();
}

glm::dvec3 weights_at(const Triangle &triangle, double x, double y) {
    const glm::dvec3 areas = areas_at(triangle, x, y);
    return areas / (areas.x + areas.y + areas.z);
}

double weights_before_cancelling(const Triangle &triangle, double x, double y) {
    const glm::dvec3 here = areas_at(triangle, x, y), start = glm::abs(areas_at(triangle, 0, 0));
    return std::max(std::max({start.x, start.y, start.z}) / std::abs(here.x + here.y + here.z), 1.0);
}

bool near_edge(const Triangle &triangle, double x, double y) {
    const Triangle s = shifted(triangle, x, y);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 g = slope(triangle[i], triangle[(i + 1) % 3]);
        const double distance = edge(s[i], s[(i + 1) % 3]);
        if (distance * distance < (g.x * g.x + g.y * g.y) * (edge_width * edge_width)) {
            return true;
        }
    }
    return false;
}

Rasteriser::Rasteriser(const std::vector<RasterObject> &objects, Size size, const DepthRange &depth)
    : objects_(objects), size_(size), depth_(depth),
      bins_(static_cast<std::size_t>((size.height + band_rows - 1) / band_rows)) {
    for (std::uint32_t object = 0; object < objects.size(); ++object) {
        for (std::uint32_t i = 0; i < objects[object].triangles->size(); ++i) {
            if (const auto box = bounds(objects[object].triangle(i))) {
                for (std::size_t band = band_of(box->top); band <= band_of(box->bottom); ++band) {
                    bins_[band].push_back({object, i});
                }
            }
        }
    }
}

std::size_t Rasteriser::band_of(int row) const { return static_cast<std::size_t>(row / band_rows); }
int Rasteriser::first_row(std::size_t band) const { return static_cast<int>(band) * band_rows; }

/// The pixels whose centres the part in front of the near plane may cover, or miss by less than edge_width.
std::optional<Rasteriser::Box> Rasteriser::bounds(const Triangle &triangle) const {
    const auto [nearest, farthest] = std::minmax({triangle[0].z, triangle[1].z, triangle[2].z});
    const double plane = depth_.linear ? 0 : depth_.near; // corners of an orthographic camera need no cut
    if (!depth_.linear && (farthest < depth_.near || nearest > depth_.far)) {
        return {};
    }
    constexpr double huge = std::numeric_limits<double>::infinity();
    glm::dvec2 low(huge);
    glm::dvec2 high(-huge);
    const auto include = [&](const glm::dvec2 &point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner &p = triangle[i];
        const Corner &q = triangle[(i + 1) % 3];
        if (p.z >= plane) {
            include(glm::dvec2(p) / p.z);
        }
        if ((p.z < plane) != (q.z < plane)) {
            const double t = (plane - p.z) / (q.z - p.z);
            include((glm::dvec2(p) + t * glm::dvec2(q - p)) / plane);
        }
    }
    // Centres lie at half pixels; the margin is edge_width and a little for rounding.
    constexpr double margin = edge_width + 1e-6;
    low = glm::max(glm::ceil(low - margin - 0.5), 0.0);
    high = glm::min(glm::floor(high + margin - 0.5), glm::dvec2(size_.width - 1.0, size_.height - 1.0));
    if (low.x > high.x || low.y > high.y) {
        return {};
    }
    return Box{static_cast<int>(low.x), static_cast<int>(high.x), static_cast<int>(low.y), static_cast<int>(high.y)};
}

bool Rasteriser::beside_wins(const Hit &hit) const { return hit.beside > hit.inverse_w - hit.resolution; }

std::vector<Hit> Rasteriser::draw(std::size_t band) const {
    const int first = first_row(band);
    const int rows = std::min(band_rows, size_.height - first);
    std::vector<Hit> hits(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(rows));
    for (const Entry &entry : bins_[band]) {
        draw_triangle(entry, first, hits);
    }
    return hits;
}

void Rasteriser::draw_triangle(const Entry &entry, int first_row, std::span<Hit> hits) const {
    const RasterObject &object = objects_[entry.object];
    const Triangle triangle = object.triangle(entry.triangle);
    glm::dvec3 nearness(1);
    if (depth_.linear) {
        const glm::uvec3 &t = (*object.triangles)[entry.triangle];
        nearness = {object.nearness[t.x], object.nearness[t.y], object.nearness[t.z]};
    }
    const Edges edges(triangle, nearness);
    const auto box = bounds(triangle);
    if (edges.sign == 0 || edges.sign == object.hidden || !box) {
        return;
    }
    const int last_row = first_row + static_cast<int>(hits.size()) / size_.width - 1;
    for (int row = std::max(first_row, box->top); row <= std::min(last_row, box->bottom); ++row) {
        for (int column = box->left; column <= box->right; ++column) {
            const Triangle p = shifted(triangle, column + 0.5, row + 0.5);
            const std::array<double, 3> e{edges.sign * edge(p[1], p[2]), edges.sign * edge(p[2], p[0]),
                                          edges.sign * edge(p[0], p[1])};
            if (e[0] < -edges.reach[0] || e[1] < -edges.reach[1] || e[2] < -edges.reach[2]) {
                continue;
            }
            const bool inside = (e[0] > 0 || (e[0] == 0 && edges.owned[0])) &&
                                (e[1] > 0 || (e[1] == 0 && edges.owned[1])) &&
                                (e[2] > 0 || (e[2] == 0 && edges.owned[2]));
            const double inverse_w = (e[0] * nearness.x + e[1] * nearness.y + e[2] * nearness.z) /
                                     (e[0] * p[0].z + e[1] * p[1].z + e[2] * p[2].z);
            const int pixel = (row - first_row) * size_.width + column;
            Hit &hit = hits[static_cast<std::size_t>(pixel)];
            if (!inside) {
                const double beside = std::clamp(inverse_w, edges.lowest, edges.highest);
                hit.beside = std::max(hit.beside, beside <= depth_.nearest() ? beside : 0);
            } else if (depth_.holds(inverse_w)) {
                const double resolution = depth_.resolution(inverse_w, edges.highest);
                keep_nearer(hit, {entry.object + 1, entry.triangle, inverse_w, 0, false, resolution});
            }
        }
    }
}

} // namespace sandbox::reference
