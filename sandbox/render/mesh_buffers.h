#pragma once

#include "render/gl_object.h"
#include "scene/mesh.h"

#include <map>
#include <memory>

namespace sandbox {

/// Which vertex attributes a program reads (locations as in vertex.glsl), and in which arrangement.
struct VertexLayout {
    bool flat = false; ///< unshared vertices that carry their face's normal and centroid
    bool normal = false, uv = false, centroid = false;
    auto operator<=>(const VertexLayout &) const = default;
};

/// A mesh on the GPU: a buffer for each attribute, made when a program first needs it.
class MeshBuffers {
  public:
    /// `origin` is subtracted from the positions before they are rounded to float32.
    MeshBuffers(std::shared_ptr<const Mesh> mesh, const glm::dvec3 &origin) : mesh_(std::move(mesh)), origin_(origin) {}
    /// Draws all triangles with the program and framebuffer in use.
    void draw(const VertexLayout &layout);

  private:
    struct Arrangement { ///< shared (indexed) or flat vertices
        Buffer positions, normals, uvs, centroids, indices;
    };
    VertexArray make_array(const VertexLayout &layout);

    std::shared_ptr<const Mesh> mesh_;
    glm::dvec3 origin_;
    Arrangement shared_, flat_;
    std::map<VertexLayout, VertexArray> arrays_;
};

} // namespace sandbox
