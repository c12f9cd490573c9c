#pragma once

#include "image/image.h"
#include "scene/assets.h"
#include "scene/mesh.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

/// The mesh and the texture of one object. The same shape (with the same repeats of a texture) gives the same mesh as
/// long as anyone holds it; the same texture gives the same image until it is evicted.
struct ObjectResources {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Image> texture; ///< linear light; null: none
    /// Who draws the mesh rounds its vertices' window positions to so many steps a pixel and interpolates between
    /// those, as GPUs do; 0: not at all.
    int window_grid = 0;
};

/// A shape, and how often a texture repeats on it.
using MeshKey = std::pair<Shape, glm::dvec2>;

/// Builds or reads the meshes and textures that scenes name, and keeps those that the latest scene uses.
class Resources {
  public:
    explicit Resources(Assets assets);

    /// One entry per object of `scene`. Throws InputError (unknown texture, bad OBJ, more than budget.h allows) and
    /// then changes nothing.
    std::vector<ObjectResources> load(const Scene &scene);

    /// ObjectResources::window_grid of all that is loaded from here on.
    void set_window_grid(int steps) { window_grid_ = steps; }

  private:
    struct Loading;
    [[nodiscard]] std::shared_ptr<const Mesh> kept_mesh(const MeshKey &key) const;
    std::shared_ptr<const Mesh> mesh_of(std::size_t object, Loading &now) const;
    std::shared_ptr<const Image> texture_of(std::size_t object, Loading &now) const;

    Assets assets_;
    int window_grid_ = 0;
    std::vector<std::pair<MeshKey, std::shared_ptr<const Mesh>>> meshes_;
    /// Meshes of earlier scenes that someone else still holds: going back and forth between scenes builds nothing anew.
    std::vector<std::pair<MeshKey, std::weak_ptr<const Mesh>>> earlier_meshes_;
    std::map<std::pair<std::string, ColorSpace>, std::shared_ptr<const Image>> textures_;
};

} // namespace sandbox
