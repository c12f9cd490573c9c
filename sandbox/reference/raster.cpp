#include "reference/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sandbox::reference {

namespace {

constexpr int band_rows = 16;

/// Two depths closer than this, in OpenGL's depth range [0, 1], may come out in either order: a float32 depth buffer
/// resolves 6e-8 near 1, and the interpolated depth carries a few such steps.
constexpr double depth_resolution = 4e-7;

/// The edge from p to q, from a point's own shifted corners: positive to one side, exactly the negative when p and q
/// are exchanged (so two triangles that share an edge agree on every pixel).
double edge(const Corner &p, const Corner &q) { return p.x * q.y - q.x * p.y; }

Corner shifted(const Corner &corner, double x, double y) {
    return {corner.x - corner.z * x, corner.y - corner.z * y, corner.z};
}

/// How the edge function from p to q grows per pixel to the right (x) and down (y).
glm::dvec2 slope(const Corner &p, const Corner &q) { return {p.y * q.z - q.y * p.z, p.z * q.x - q.z * p.x}; }

/// Does a centre exactly on this edge belong to the triangle on its positive side? Left edges and top edges own it.
bool owns(const glm::dvec2 &slope) { return slope.x > 0 || (slope.x == 0 && slope.y > 0); }

/// The edges opposite each corner, turned so that the inside is positive.
struct Edges {
    std::array<Corner, 3> corners;
    double sign = 0; ///< 0: the triangle is seen edge-on
    std::array<bool, 3> owns_{};
    std::array<double, 3> reach{};  ///< the edge function's growth over edge_width
    double lowest = 0, highest = 0; ///< 1 / w over the corners, where all lie in front

    Edges(const Corner &a, const Corner &b, const Corner &c) : corners{a, b, c} {
        const Corner at = a.z != 0 ? Corner{a.x / a.z, a.y / a.z, 1} : Corner{0, 0, 1};
        const std::array<Corner, 3> s{shifted(a, at.x, at.y), shifted(b, at.x, at.y), shifted(c, at.x, at.y)};
        const double volume = edge(s[1], s[2]) * a.z + edge(s[2], s[0]) * b.z + edge(s[0], s[1]) * c.z;
        sign = volume > 0 ? 1 : (volume < 0 ? -1 : 0);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 g = sign * slope(corners[(i + 1) % 3], corners[(i + 2) % 3]);
            owns_[i] = owns(g);
            reach[i] = std::hypot(g.x, g.y) * edge_width;
        }
        const bool front = a.z > 0 && b.z > 0 && c.z > 0;
        lowest = front ? 1 / std::max({a.z, b.z, c.z}) : 0;
        highest = front ? 1 / std::min({a.z, b.z, c.z}) : std::numeric_limits<double>::infinity();
    }
};

void keep_nearer(Hit &kept, Hit drawn, double resolution) {
    const double lead = drawn.inverse_w - kept.inverse_w;
    const bool tie = kept.object != 0 && std::abs(lead) < resolution;
    if (lead > 0) {
        drawn.beside = kept.beside;
        drawn.tie = tie;
        kept = drawn;
    } else {
        kept.tie = kept.tie || tie;
    }
}

} // namespace

glm::dvec3 weights_at(const Corner &a, const Corner &b, const Corner &c, double x, double y) {
    const Corner p = shifted(a, x, y);
    const Corner q = shifted(b, x, y);
    const Corner r = shifted(c, x, y);
    const glm::dvec3 areas(edge(q, r), edge(r, p), edge(p, q));
    return areas / (areas.x + areas.y + areas.z);
}

bool near_edge(const Corner &a, const Corner &b, const Corner &c, double x, double y) {
    const std::array<Corner, 3> corners{a, b, c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner &p = corners[i];
        const Corner &q = corners[(i + 1) % 3];
        const glm::dvec2 g = slope(p, q);
        const double distance = edge(shifted(p, x, y), shifted(q, x, y));
        if (distance * distance < (g.x * g.x + g.y * g.y) * (edge_width * edge_width)) {
            return true;
        }
    }
    return false;
}

Rasteriser::Rasteriser(const std::vector<RasterObject> &objects, Size size, double near, double far)
    : objects_(objects), size_(size), near_(near), far_(far),
      bins_(static_cast<std::size_t>((size.height + band_rows - 1) / band_rows)) {
    for (std::uint32_t object = 0; object < objects.size(); ++object) {
        const std::vector<glm::uvec3> &triangles = *objects[object].triangles;
        const std::vector<Corner> &corners = objects[object].corners;
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            Box box{};
            if (bounds(corners[triangles[i].x], corners[triangles[i].y], corners[triangles[i].z], box)) {
                const int last = static_cast<int>(box.bottom) / band_rows;
                for (int band = static_cast<int>(box.top) / band_rows; band <= last; ++band) {
                    bins_[static_cast<std::size_t>(band)].push_back({object, i});
                }
            }
        }
    }
}

std::size_t Rasteriser::band_of(int row) const { return static_cast<std::size_t>(row / band_rows); }
int Rasteriser::first_row(std::size_t band) const { return static_cast<int>(band) * band_rows; }
int Rasteriser::end_row(std::size_t band) const { return std::min(first_row(band) + band_rows, size_.height); }

/// The pixels whose centres the part in front of the near plane may cover or pass within edge_width; false if none.
bool Rasteriser::bounds(const Corner &a, const Corner &b, const Corner &c, Box &box) const {
    if (std::max({a.z, b.z, c.z}) < near_ || std::min({a.z, b.z, c.z}) > far_) {
        return false;
    }
    constexpr double huge = std::numeric_limits<double>::infinity();
    box = {huge, -huge, huge, -huge};
    const auto include = [&](double x, double y) {
        box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
    };
    const std::array<Corner, 3> corners{a, b, c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner &p = corners[i];
        const Corner &q = corners[(i + 1) % 3];
        if (p.z >= near_) {
            include(p.x / p.z, p.y / p.z);
        }
        if ((p.z < near_) != (q.z < near_)) {
            const double t = (near_ - p.z) / (q.z - p.z);
            include((p.x + t * (q.x - p.x)) / near_, (p.y + t * (q.y - p.y)) / near_);
        }
    }
    // Centres lie at half pixels; one edge width more for the neighbours, and a little for rounding.
    constexpr double margin = edge_width + 1e-6;
    box.left = std::max(std::ceil(box.left - margin - 0.5), 0.0);
    box.top = std::max(std::ceil(box.top - margin - 0.5), 0.0);
    box.right = std::min(std::floor(box.right + margin - 0.5), size_.width - 1.0);
    box.bottom = std::min(std::floor(box.bottom + margin - 0.5), size_.height - 1.0);
    return box.left <= box.right && box.top <= box.bottom;
}

bool Rasteriser::beside_wins(const Hit &hit) const { return hit.beside > hit.inverse_w - depth_resolution / near_; }

std::vector<Hit> Rasteriser::draw(std::size_t band) const {
    const int first = first_row(band);
    const int end = end_row(band);
    std::vector<Hit> hits(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(end - first));
    for (const Entry &entry : bins_[band]) {
        draw_triangle(entry, first, end, hits);
    }
    return hits;
}

void Rasteriser::draw_triangle(const Entry &entry, int first_row, int end_row, std::span<Hit> hits) const {
    const RasterObject &object = objects_[entry.object];
    const glm::uvec3 &triangle = (*object.triangles)[entry.triangle];
    const Edges edges(object.corners[triangle.x], object.corners[triangle.y], object.corners[triangle.z]);
    Box box{};
    if (edges.sign == 0 || edges.sign == object.hidden ||
        !bounds(edges.corners[0], edges.corners[1], edges.corners[2], box)) {
        return;
    }
    const double resolution = depth_resolution / near_;
    const int left = static_cast<int>(box.left);
    const int right = static_cast<int>(box.right);
    for (int row = std::max(first_row, static_cast<int>(box.top));
         row < std::min(end_row, static_cast<int>(box.bottom) + 1); ++row) {
        for (int column = left; column <= right; ++column) {
            const double x = column + 0.5;
            const double y = row + 0.5;
            const std::array<Corner, 3> p{shifted(edges.corners[0], x, y), shifted(edges.corners[1], x, y),
                                          shifted(edges.corners[2], x, y)};
            const std::array<double, 3> e{edges.sign * edge(p[1], p[2]), edges.sign * edge(p[2], p[0]),
                                          edges.sign * edge(p[0], p[1])};
            if (e[0] < -edges.reach[0] || e[1] < -edges.reach[1] || e[2] < -edges.reach[2]) {
                continue;
            }
            const bool inside = (e[0] > 0 || (e[0] == 0 && edges.owns_[0])) &&
                                (e[1] > 0 || (e[1] == 0 && edges.owns_[1])) &&
                                (e[2] > 0 || (e[2] == 0 && edges.owns_[2]));
            const double inverse_w = (e[0] + e[1] + e[2]) / (e[0] * p[0].z + e[1] * p[1].z + e[2] * p[2].z);
            Hit &hit = hits[static_cast<std::size_t>(row - first_row) * static_cast<std::size_t>(size_.width) +
                            static_cast<std::size_t>(column)];
            if (!inside) {
                const double beside = std::clamp(inverse_w, edges.lowest, edges.highest);
                hit.beside = std::max(hit.beside, beside <= 1 / near_ ? beside : 0);
            } else if (inverse_w * near_ <= 1 && inverse_w * far_ >= 1) {
                const Hit drawn{entry.object + 1, entry.triangle, inverse_w, 0, false};
                keep_nearer(hit, drawn, resolution);
            }
        }
    }
}

} // namespace sandbox::reference
