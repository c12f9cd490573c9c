#pragma once

#include "render/gl_object.h"
#include "scene/mesh.h"
#include "shading/needs.h"

#include <map>
#include <memory>

namespace sandbox {

/// A mesh on the GPU: a buffer for each attribute, made when a program first needs it.
class MeshBuffers {
  public:
    /// `origin` is subtracted from the positions before they are rounded to float32.
    MeshBuffers(std::shared_ptr<const Mesh> mesh, const glm::dvec3 &origin) : mesh_(std::move(mesh)), origin_(origin) {}
    /// Draws all triangles with the program and framebuffer in use.
    void draw(const VertexAttributes &attributes);

  private:
    struct Arrangement { ///< shared (indexed) or flat vertices
        Buffer positions, normals, uvs, centroids, indices;
    };
    VertexArray make_array(const VertexAttributes &attributes);

    std::shared_ptr<const Mesh> mesh_;
    glm::dvec3 origin_;
    Arrangement shared_, flat_;
    std::map<VertexAttributes, VertexArray> arrays_;
};

} // namespace sandbox
