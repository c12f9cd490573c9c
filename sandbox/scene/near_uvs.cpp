#include "scene/near_uvs.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace sandbox {
namespace {

/// The multiples of `step` nearest to the middle of the triangle's coordinates.
glm::dvec2 offset_of(const Mesh &mesh, const glm::uvec3 &t, double step) {
    const glm::dvec2 &a = mesh.uvs[t.x];
    const glm::dvec2 &b = mesh.uvs[t.y];
    const glm::dvec2 &c = mesh.uvs[t.z];
    const glm::dvec2 middle = 0.5 * (glm::min(glm::min(a, b), c) + glm::max(glm::max(a, b), c));
    return step * glm::round(middle / step);
}

/// A copy of a mesh whose vertices go apart where their triangles take off different amounts.
class Splitter {
  public:
    Splitter(const Mesh &mesh, double step) : mesh_(mesh), step_(step), split_(mesh), taken_(mesh.positions.size()) {}

    Mesh split() {
        for (glm::uvec3 &t : split_.triangles) {
            const glm::dvec2 offset = offset_of(mesh_, t, step_);
            t = {vertex(t.x, offset), vertex(t.y, offset), vertex(t.z, offset)};
        }
        return std::move(split_);
    }

  private:
    /// The vertex `v` less `offset`: itself for the first offset that is asked for, else one more.
    unsigned vertex(unsigned v, const glm::dvec2 &offset) {
        const glm::dvec2 uv = mesh_.uvs[v] - offset;
        if (!taken_[v]) {
            taken_[v] = offset;
            split_.uvs[v] = uv;
        }
        if (*taken_[v] == offset) {
            return v;
        }
        const auto next = static_cast<unsigned>(split_.positions.size());
        const auto [found, added] = more_.try_emplace({v, offset.x, offset.y}, next);
        if (added) {
            split_.positions.push_back(mesh_.positions[v]);
            split_.normals.push_back(mesh_.normals[v]);
            if (!mesh_.file_normals.empty()) {
                split_.file_normals.push_back(mesh_.file_normals[v]);
            }
            split_.uvs.push_back(uv);
            if (!mesh_.colors.empty()) {
                split_.colors.push_back(mesh_.colors[v]);
            }
        }
        return found->second;
    }

    const Mesh &mesh_;
    double step_;
    Mesh split_;
    std::vector<std::optional<glm::dvec2>> taken_; ///< by each of the mesh's own vertices
    std::map<std::tuple<unsigned, double, double>, unsigned> more_;
};

} // namespace

std::shared_ptr<const Mesh> with_near_uvs(const std::shared_ptr<const Mesh> &mesh, double step) {
    const auto is_far = [&](const glm::uvec3 &t) { return offset_of(*mesh, t, step) != glm::dvec2(0); };
    const auto is_near = [&](const glm::dvec2 &uv) {
        return glm::all(glm::lessThan(glm::abs(uv), glm::dvec2(step / 2)));
    };
    if (std::ranges::all_of(mesh->uvs, is_near) || std::ranges::none_of(mesh->triangles, is_far)) {
        return mesh;
    }
    return std::make_shared<const Mesh>(Splitter(*mesh, step).split());
}

std::shared_ptr<const Mesh> with_repeated_uvs(const std::shared_ptr<const Mesh> &mesh, const glm::dvec2 &repeat) {
    if (repeat == glm::dvec2(1)) {
        return mesh;
    }
    Mesh repeated = *mesh;
    for (glm::dvec2 &uv : repeated.uvs) {
        uv *= repeat;
    }
    return with_near_uvs(std::make_shared<const Mesh>(std::move(repeated)), 1);
}

} // namespace sandbox
