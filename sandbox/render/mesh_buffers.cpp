#include "render/mesh_buffers.h"

#include "image/error.h"

#include <glad/gl.h>
#include <glm/geometric.hpp>

#include <array>
#include <functional>
#include <vector>

namespace sandbox {
namespace {

template <typename Element> Buffer make_filled(GLenum target, const std::vector<Element> &elements) {
    Buffer buffer = make_buffer();
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(), GL_STATIC_DRAW);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw MachineError("the driver has no memory for a mesh of " + std::to_string(elements.size()) + " elements");
    }
    return buffer;
}

/// One float vector per shared vertex, or per triangle corner where `flat`.
template <typename Vector, typename Value>
Buffer make_attribute(const Mesh &mesh, bool flat, const Value &value_of_corner) {
    std::vector<Vector> values;
    if (!flat) {
        values.resize(mesh.positions.size());
    }
    for (const glm::uvec3 &triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto value = Vector(value_of_corner(triangle, triangle[corner]));
            if (flat) {
                values.push_back(value);
            } else {
                values[triangle[corner]] = value;
            }
        }
    }
    return make_filled(GL_ARRAY_BUFFER, values);
}

/// The face's own normal, turned to the side of its vertices' mean normal; that mean where the face has no area.
glm::dvec3 face_normal(const Mesh &mesh, const glm::uvec3 &t) {
    const auto &p = mesh.positions;
    const glm::dvec3 mean = mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z];
    const glm::dvec3 normal = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
    const double length = glm::length(normal);
    if (length == 0) {
        return mean;
    }
    return glm::dot(normal, mean) < 0 ? -normal / length : normal / length;
}

void bind_attribute(GLuint location, const Buffer &buffer, GLint components) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

} // namespace

void MeshBuffers::upload(Arrangement &a, const VertexLayout &layout) const {
    const Mesh &mesh = *mesh_;
    const bool flat = layout.flat;
    if (a.positions.id() == 0) {
        a.count = static_cast<int>(mesh.triangles.size() * 3);
        a.positions = make_attribute<glm::vec3>(
            mesh, flat, [&](const glm::uvec3 &, unsigned vertex) { return mesh.positions[vertex] - origin_; });
        if (!flat) {
            a.indices = make_filled(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
        }
    }
    if (layout.normal && a.normals.id() == 0) {
        a.normals = make_attribute<glm::vec3>(mesh, flat, [&](const glm::uvec3 &t, unsigned vertex) {
            return flat ? face_normal(mesh, t) : mesh.normals[vertex];
        });
    }
    if (layout.uv && a.uvs.id() == 0) {
        a.uvs = make_attribute<glm::vec2>(mesh, flat, [&](const glm::uvec3 &, unsigned vertex) {
            return mesh.uvs.empty() ? glm::dvec2(0) : mesh.uvs[vertex];
        });
    }
    if (layout.centroid && a.centroids.id() == 0) {
        a.centroids = make_attribute<glm::vec3>(mesh, flat, [&](const glm::uvec3 &t, unsigned) {
            return (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0 - origin_;
        });
    }
}

VertexArray MeshBuffers::make_array(const VertexLayout &layout) {
    glBindVertexArray(0);
    Arrangement &a = layout.flat ? flat_ : shared_;
    upload(a, layout);
    VertexArray array = make_vertex_array();
    glBindVertexArray(array.id());
    bind_attribute(0, a.positions, 3);
    if (layout.normal) {
        bind_attribute(1, a.normals, 3);
    }
    if (layout.uv) {
        bind_attribute(2, a.uvs, 2);
    }
    if (layout.centroid) {
        bind_attribute(3, a.centroids, 3);
    }
    if (!layout.flat) {
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, a.indices.id());
    }
    return array;
}

void MeshBuffers::draw(const VertexLayout &layout) {
    auto found = arrays_.find(layout);
    if (found == arrays_.end()) {
        found = arrays_.emplace(layout, make_array(layout)).first;
    }
    glBindVertexArray(found->second.id());
    if (layout.flat) {
        glDrawArrays(GL_TRIANGLES, 0, flat_.count);
    } else {
        glDrawElements(GL_TRIANGLES, shared_.count, GL_UNSIGNED_INT, nullptr);
    }
    glBindVertexArray(0);
}

} // namespace sandbox
