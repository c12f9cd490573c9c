#include "scene/mesh_backs.h"

#include "scene/index_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

std::uint64_t hash_of(const glm::dvec3 &p) {
    std::uint64_t hash = 0;
    for (const double part : {p.x, p.y, p.z}) {
        hash = mixed(hash + 0x9e3779b97f4a7c15U + std::bit_cast<std::uint64_t>(part + 0.0)); // -0 is 0
    }
    return hash;
}

/// Of each vertex the first one at its position.
std::vector<std::uint32_t> merged_vertices(const Mesh &mesh) {
    const std::vector<glm::dvec3> &p = mesh.positions;
    IndexTable first(p.size());
    std::vector<std::uint32_t> merged;
    merged.reserve(p.size());
    for (std::uint32_t i = 0; i < p.size(); ++i) {
        merged.push_back(first.find_or_put(hash_of(p[i]), i, [&](std::uint32_t j) { return p[j] == p[i]; }));
    }
    return merged;
}

/// Sets of connected vertices (union-find with halved paths).
class Parts {
  public:
    explicit Parts(std::size_t vertices) : parent_(vertices) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t of(std::uint32_t vertex) {
        while (parent_[vertex] != vertex) {
            parent_[vertex] = parent_[parent_[vertex]];
            vertex = parent_[vertex];
        }
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[of(a)] = of(b); }

  private:
    std::vector<std::uint32_t> parent_;
};

/// Of one part.
struct Sums {
    double volume = 0, total = 0; ///< six times the signed volume; what it was added up from
    std::uint64_t edges = 0;      ///< 0 if every edge is run along as often one way as the other
};

} // namespace

BacksSeen backs_seen(const Mesh &mesh) {
    const std::vector<std::uint32_t> merged = merged_vertices(mesh);
    Parts parts(merged.size());
    for (const glm::uvec3 &t : mesh.triangles) {
        parts.join(merged[t.x], merged[t.y]);
        parts.join(merged[t.y], merged[t.z]);
    }
    std::vector<Sums> sums(merged.size());
    const glm::dvec3 middle = (mesh.bounds.low + mesh.bounds.high) / 2.0;
    for (const glm::uvec3 &t : mesh.triangles) {
        Sums &own = sums[parts.of(merged[t.x])];
        const double volume = glm::dot(mesh.positions[t.x] - middle,
                                       glm::cross(mesh.positions[t.y] - middle, mesh.positions[t.z] - middle));
        own.volume += volume;
        own.total += std::abs(volume);
        for (const auto &[from, to] : {std::pair(merged[t.x], merged[t.y]), std::pair(merged[t.y], merged[t.z]),
                                       std::pair(merged[t.z], merged[t.x])}) {
            // A random number per edge, counted up one way and down the other: a sum of 0 by chance has odds of 2^-64.
            const std::uint64_t low = std::min(from, to);
            const std::uint64_t number = mixed(low << 32U | std::max(from, to));
            own.edges += from < to ? number : 0 - number;
        }
    }
    BacksSeen seen = BacksSeen::none;
    for (const glm::uvec3 &t : mesh.triangles) {
        const Sums &own = sums[parts.of(merged[t.x])];
        if (own.edges != 0 || std::abs(own.volume) <= 1e-9 * own.total) { // 1e-9: rounding of a million terms
            return BacksSeen::open;
        }
        seen = own.volume < 0 ? BacksSeen::inside_out : seen;
    }
    return seen;
}

} // namespace sandbox
