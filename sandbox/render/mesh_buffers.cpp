#include "render/mesh_buffers.h"

#include "render/gl.h"
#include "render/gl_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

namespace sandbox {
namespace {

template <typename Element> Buffer make_filled(GLenum target, const std::vector<Element> &elements) {
    Buffer buffer = make_buffer();
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(), GL_STATIC_DRAW);
    check_gl(fmt::format("store a mesh of {} elements", elements.size()));
    return buffer;
}

/// One vector per shared vertex, or per triangle corner where `flat`: value_at(triangle, vertex), where `triangle`
/// counts only if flat.
template <typename ValueAt> Buffer make_attribute(const Mesh &mesh, bool flat, const ValueAt &value_at) {
    std::vector<std::invoke_result_t<ValueAt, glm::uvec3, unsigned>> values;
    values.reserve(flat ? 3 * mesh.triangles.size() : mesh.positions.size());
    if (flat) {
        for (const glm::uvec3 &triangle : mesh.triangles) {
            for (int corner = 0; corner < 3; ++corner) {
                values.push_back(value_at(triangle, triangle[corner]));
            }
        }
    } else {
        for (unsigned v = 0; v < mesh.positions.size(); ++v) {
            values.push_back(value_at({}, v));
        }
    }
    return make_filled(GL_ARRAY_BUFFER, values);
}

} // namespace

Buffer make_index_buffer(const std::vector<glm::uvec3> &triangles) {
    glBindVertexArray(0); // whose indices these would become
    return make_filled(GL_ELEMENT_ARRAY_BUFFER, triangles);
}

VertexArray MeshBuffers::make_array(const VertexAttributes &attributes) {
    const Mesh &mesh = *mesh_;
    const bool flat = attributes.flat;
    Arrangement &buffers = flat ? flat_ : shared_;
    VertexArray array = make_vertex_array();
    glBindVertexArray(array.id());
    const auto attach = [&](GLuint location, Buffer &buffer, const auto &value_at) {
        if (buffer.id() == 0) {
            buffer = make_attribute(mesh, flat, value_at);
        }
        glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, decltype(value_at({}, 0U))::length(), GL_FLOAT, GL_FALSE, 0, nullptr);
    };
    attach(0, buffers.positions,
           [&](const glm::uvec3 &, unsigned v) { return glm::vec3(mesh.positions[v] - origin_); });
    if (attributes.normal) {
        attach(1, buffers.normals, [&](const glm::uvec3 &t, unsigned v) {
            return glm::vec3(flat ? facet_normal(mesh, t) : mesh.normals[v]);
        });
    }
    if (attributes.uv) {
        attach(2, buffers.uvs, [&](const glm::uvec3 &, unsigned v) {
            return mesh.uvs.empty() ? glm::vec2(0) : glm::vec2(mesh.uvs[v]);
        });
    }
    if (attributes.centroid) {
        attach(3, buffers.centroids, [&](const glm::uvec3 &t, unsigned) {
            return glm::vec3((mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0 - origin_);
        });
    }
    if (attributes.color) {
        attach(4, buffers.colors, [&](const glm::uvec3 &, unsigned v) { return glm::vec3(mesh.colors[v]); });
    }
    if (!flat) {
        if (buffers.indices.id() == 0) {
            buffers.indices = make_filled(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
        }
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.indices.id());
    }
    return array;
}

void MeshBuffers::draw(const VertexAttributes &attributes, const std::optional<TrianglePart> &part) {
    auto found = arrays_.find(attributes);
    if (found == arrays_.end()) {
        found = arrays_.emplace(attributes, make_array(attributes)).first;
    }
    glBindVertexArray(found->second.id());
    const auto corners = static_cast<GLsizei>(mesh_->triangles.size() * 3);
    if (attributes.flat) {
        glDrawArrays(GL_TRIANGLES, 0, corners);
    } else if (part) {
        const std::size_t offset = part->first * sizeof(glm::uvec3);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, part->indices);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part->count * 3), GL_UNSIGNED_INT,
                       reinterpret_cast<const void *>(offset)); // NOLINT(performance-no-int-to-ptr): OpenGL's way
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, shared_.indices.id());
    } else {
        glDrawElements(GL_TRIANGLES, corners, GL_UNSIGNED_INT, nullptr);
    }
    glBindVertexArray(0);
}

void MeshBuffers::draw_edges() {
    if (!edges_) {
        std::vector<std::array<unsigned, 2>> edges;
        edges.reserve(3 * mesh_->triangles.size());
        for (const glm::uvec3 &triangle : mesh_->triangles) {
            for (int corner = 0; corner < 3; ++corner) {
                const auto [first, second] = std::minmax(triangle[corner], triangle[(corner + 1) % 3]);
                edges.push_back({first, second});
            }
        }
        std::ranges::sort(edges);
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        Edges made{make_array({}), {}, static_cast<int>(2 * edges.size())};
        made.indices = make_filled(GL_ELEMENT_ARRAY_BUFFER, edges); // of the array, in place of the triangles
        edges_ = std::move(made);
    }
    glBindVertexArray(edges_->array.id());
    glDrawElements(GL_LINES, edges_->count, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

const std::vector<MarkedVertex> &MeshBuffers::marked(bool flat, const glm::dvec3 &scale, double apart) {
    for (const Marked &made : marked_) {
        if (made.flat == flat && made.scale == scale && made.apart == apart) {
            return made.vertices;
        }
    }
    constexpr std::size_t most = 8; // sides, objects of one mesh, normals and vertices
    if (marked_.size() == most) {
        marked_.pop_front();
    }
    return marked_.emplace_back(Marked{flat, scale, apart, thinned_out(marked_vertices(*given_, flat), scale, apart)})
        .vertices;
}

} // namespace sandbox
