#include "scene/obj_mesh.h"

#include "image/error.h"
#include "scene/index_table.h"
#include "scene/polygon.h"
#include "scene/unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

double largest_part(const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// What vertices of the mesh differ by: the position, the texture coordinates and `normal`, an index into the file's,
/// or into the computed ones where marked. The corner is the first that is this vertex.
struct Vertex {
    ObjCorner corner;
    std::uint32_t normal = 0;

    [[nodiscard]] bool is(const Vertex &other) const {
        return corner.v == other.corner.v && corner.vt == other.corner.vt && normal == other.normal;
    }
    [[nodiscard]] std::uint64_t hash() const {
        return mixed(mixed(std::uint64_t{corner.v} << 32U | corner.vt) + normal);
    }
};

/// Sums of faces' area vectors around one position.
struct NormalSum {
    glm::dvec3 sum{0}, first{0};
    double total = 0;

    void add(const glm::dvec3 &area) {
        sum += area;
        total += largest_part(area);
        if (first == glm::dvec3(0)) {
            first = area;
        }
    }
    /// Where they cancel (two faces back to back), the first face's, so that no normal is zero. 1e-12: below this share
    /// of what was added, a sum is rounding error.
    [[nodiscard]] glm::dvec3 normal() const { return unit(largest_part(sum) <= 1e-12 * total ? first : sum); }
};

class MeshBuilder {
  public:
    explicit MeshBuilder(const ObjFaces &file) : file_(file) { add_up_normals(); }

    Mesh whole() {
        mesh_.triangles.reserve(file_.corners.size() - 2 * file_.faces.size());
        for (const ObjFace &face : file_.faces) {
            add_face(face);
        }
        add_vertices();
        keep_file_normals();
        return std::move(mesh_);
    }

    /// The faces with these indices.
    Mesh part(std::span<const std::uint32_t> faces) {
        mesh_ = {};
        vertices_.clear();
        vertex_of_ = IndexTable(faces.size() / 2); // as many vertices has a closed mesh
        std::size_t triangles = 0;
        for (const std::uint32_t i : faces) {
            triangles += file_.faces[i].corner_count - 2;
        }
        mesh_.triangles.reserve(triangles);
        for (const std::uint32_t i : faces) {
            add_face(file_.faces[i]);
        }
        add_vertices();
        return std::move(mesh_);
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffU;
    /// Marks Vertex::normal.
    static constexpr std::uint32_t computed = 0x80000000U;
    static constexpr std::uint64_t own_key = ~std::uint64_t{0};

    const ObjFaces &file_;
    Mesh mesh_;
    IndexTable vertex_of_;
    std::vector<Vertex> vertices_; ///< of the mesh
    IndexTable sum_of_;
    std::vector<std::uint64_t> sum_keys_;            ///< of each sum: group and position; `own_key`: of a face
    std::vector<NormalSum> sums_;                    ///< the computed normals
    std::vector<std::array<std::uint32_t, 3>> flat_; ///< triangles without area, which are dropped, by position
    std::vector<glm::dvec3> points_;                 ///< of the face at hand

    const std::vector<glm::dvec3> &points_of(const ObjFace &face) {
        points_.clear();
        for (const ObjCorner &corner : file_.corners_of(face)) {
            points_.push_back(file_.positions[corner.v]);
        }
        return points_;
    }

    std::uint32_t sum_index(SmoothingGroup group, std::uint32_t position) {
        const std::uint64_t key = std::uint64_t{group} << 32U | position;
        const auto next = static_cast<std::uint32_t>(sums_.size());
        const std::uint32_t found =
            sum_of_.find_or_put(mixed(key), next, [&](std::uint32_t i) { return sum_keys_[i] == key; });
        if (found == next) {
            add_sum(key);
        }
        return found;
    }

    NormalSum &add_sum(std::uint64_t key) {
        sum_keys_.push_back(key);
        return sums_.emplace_back();
    }

    /// Every face counts, also one whose own corners have normals.
    void add_up_normals() {
        if (std::ranges::all_of(file_.corners, [&](const ObjCorner &corner) { return file_.has_normal(corner); })) {
            return;
        }
        for (const ObjFace &face : file_.faces) {
            if (face.group == unsmoothed) {
                continue;
            }
            const glm::dvec3 area = area_vector(points_of(face));
            std::uint32_t before = none;
            for (const ObjCorner &corner : file_.corners_of(face)) {
                if (corner.v != before) { // a corner given twice counts once
                    sums_[sum_index(face.group, corner.v)].add(area);
                }
                before = corner.v;
            }
        }
    }

    void add_face(const ObjFace &face) {
        const std::vector<glm::dvec3> &points = points_of(face);
        const glm::dvec3 area = area_vector(points);
        const std::span<const ObjCorner> corners = file_.corners_of(face);
        std::uint32_t own_normal = none; // of the whole face, made when it is needed
        const auto normal_of = [&](const ObjCorner &corner) {
            if (file_.has_normal(corner)) {
                return corner.vn;
            }
            if (face.group != unsmoothed) {
                return computed | sum_index(face.group, corner.v);
            }
            if (own_normal == none) {
                own_normal = static_cast<std::uint32_t>(sums_.size());
                add_sum(own_key).add(area);
            }
            return computed | own_normal;
        };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            if (glm::cross(points[b] - points[a], points[c] - points[a]) == glm::dvec3(0)) {
                flat_.push_back({corners[a].v, corners[b].v, corners[c].v});
                return;
            }
            glm::uvec3 triangle;
            for (int i = 0; const std::uint32_t at : {a, b, c}) {
                triangle[i++] = vertex_index(corners[at], normal_of(corners[at]));
            }
            mesh_.triangles.push_back(triangle);
        };
        if (corners.size() == 3) {
            add(0, 1, 2);
            return;
        }
        try {
            for (const PolygonTriangle &t : split_polygon(points, area)) {
                add(t[0], t[1], t[2]);
            }
        } catch (const InputError &error) {
            throw InputError("{}: {}", face.line, error.what());
        }
    }

    std::uint32_t vertex_index(const ObjCorner &corner, std::uint32_t normal) {
        const Vertex vertex{corner, normal};
        const auto next = static_cast<std::uint32_t>(vertices_.size());
        const std::uint32_t found =
            vertex_of_.find_or_put(vertex.hash(), next, [&](std::uint32_t i) { return vertices_[i].is(vertex); });
        if (found == next) {
            vertices_.push_back(vertex);
        }
        return found;
    }

    void add_vertices() {
        mesh_.positions.reserve(vertices_.size());
        mesh_.normals.reserve(vertices_.size());
        mesh_.colors.reserve(file_.colors.empty() ? 0 : vertices_.size());
        for (const auto &[corner, normal] : vertices_) {
            mesh_.positions.push_back(file_.positions[corner.v]);
            mesh_.normals.push_back((normal & computed) != 0 ? sums_[normal & ~computed].normal()
                                                             : unit(file_.normals[normal]));
            if (!file_.colors.empty()) {
                mesh_.colors.push_back(file_.colors[corner.v]);
            }
        }
        add_uvs();
    }

    void add_uvs() {
        const auto has_uv = [](const Vertex &vertex) { return vertex.corner.vt != ObjCorner::no_index; };
        if (std::ranges::any_of(vertices_, has_uv)) {
            mesh_.uvs.reserve(vertices_.size());
            for (const Vertex &vertex : vertices_) {
                mesh_.uvs.push_back(has_uv(vertex) ? file_.uvs[vertex.corner.vt] : glm::dvec2(0));
            }
        }
    }

    /// Where a reader without guards has other normals: too short or too long to be made unit in float32, or not
    /// finite.
    void keep_file_normals() {
        const auto extreme = [](const glm::dvec3 &n) { return !(largest_part(n) > 1e-18 && largest_part(n) < 1e18); };
        if (flat_.empty() && std::ranges::none_of(file_.normals, extreme)) {
            return;
        }
        std::vector<glm::vec3> sums(file_.positions.size(), glm::vec3(0));
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const glm::vec3 p(file_.positions[a]);
            const glm::vec3 face =
                glm::normalize(glm::cross(glm::vec3(file_.positions[b]) - p, glm::vec3(file_.positions[c]) - p));
            for (const std::uint32_t corner : {a, b, c}) {
                sums[corner] += face;
            }
        };
        for (const glm::uvec3 &t : mesh_.triangles) {
            add(vertices_[t.x].corner.v, vertices_[t.y].corner.v, vertices_[t.z].corner.v);
        }
        for (const auto &t : flat_) {
            add(t[0], t[1], t[2]);
        }
        for (const auto &[corner, normal] : vertices_) {
            const bool given = corner.vn < file_.normals.size();
            mesh_.file_normals.push_back(given ? glm::vec3(file_.normals[corner.vn]) : sums[corner.v]);
        }
    }
};

} // namespace

bool ObjFaces::has_normal(const ObjCorner &corner) const {
    return corner.vn < normals.size() && largest_part(normals[corner.vn]) > 0;
}

Mesh mesh_of_faces(const ObjFaces &faces) { return MeshBuilder(faces).whole(); }

std::vector<Mesh> meshes_of_faces(const ObjFaces &file) {
    std::vector<std::vector<std::uint32_t>> faces(file.materials.size());
    for (std::uint32_t i = 0; i < file.faces.size(); ++i) {
        faces[file.faces[i].material].push_back(i);
    }
    MeshBuilder builder(file);
    std::vector<Mesh> meshes;
    for (const std::vector<std::uint32_t> &own : faces) {
        meshes.push_back(builder.part(own));
    }
    return meshes;
}

} // namespace sandbox
