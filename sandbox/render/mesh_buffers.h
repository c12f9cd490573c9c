#pragma once

#include "render/gl_object.h"
#include "scene/near_uvs.h"
#include "shading/needs.h"
#include "shading/vertex_marks.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace sandbox {

/// Triangles of a mesh, one after the other in an index buffer of their own.
struct TrianglePart {
    unsigned indices;
    std::size_t first, count; ///< triangles
};

/// The indices of triangles, in their order.
Buffer make_index_buffer(const std::vector<glm::uvec3> &triangles);

/// A mesh on the GPU: a buffer for each attribute, made when a program first needs it.
class MeshBuffers {
  public:
    /// `origin` is subtracted from the positions before they are rounded to float32; whole numbers from texture
    /// coordinates that are far from 0 (near_uvs.h).
    MeshBuffers(std::shared_ptr<const Mesh> mesh, const glm::dvec3 &origin)
        : given_(std::move(mesh)), mesh_(with_near_uvs(given_)), origin_(origin) {}
    /// Does nobody else hold the mesh that these buffers and their owner's key name?
    [[nodiscard]] bool unused() const { return given_.use_count() <= (mesh_ == given_ ? 3 : 2); }
    /// Draws all triangles or, of shared vertices, a part of them, with the program and framebuffer in use.
    void draw(const VertexAttributes &attributes, const std::optional<TrianglePart> &part = {});
    /// Each edge of a triangle once, as a line.
    void draw_edges();
    /// What is marked of the mesh as given: see marked_vertices() and thinned_out().
    const std::vector<MarkedVertex> &marked(bool flat, const glm::dvec3 &scale, double apart);

  private:
    struct Arrangement { ///< shared (indexed) or flat vertices
        Buffer positions, normals, uvs, centroids, colors, indices;
    };
    VertexArray make_array(const VertexAttributes &attributes);

    std::shared_ptr<const Mesh> given_, mesh_; ///< mesh_: as stored
    glm::dvec3 origin_;
    Arrangement shared_, flat_;
    struct Edges {
        VertexArray array;
        Buffer indices;
        int count = 0;
    };
    std::optional<Edges> edges_;
    std::map<VertexAttributes, VertexArray> arrays_;
    struct Marked {
        bool flat;
        glm::dvec3 scale;
        double apart;
        std::vector<MarkedVertex> vertices;
    };
    std::deque<Marked> marked_; ///< the latest
};

} // namespace sandbox
