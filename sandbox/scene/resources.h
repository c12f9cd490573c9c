#pragma once

#include "image/image.h"
#include "scene/assets.h"
#include "scene/mesh.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sandbox {

/// What one object needs besides its numbers. The same shape gives the same mesh as long as anyone holds it; the same
/// texture gives the same pointer until evicted.
struct ObjectResources {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Image> texture; ///< null: none
};

/// Builds or reads the meshes and textures that scenes name, and keeps those that the latest scene uses.
class Resources {
  public:
    explicit Resources(Assets assets);

    /// One entry per object of `scene`. Throws InputError (unknown texture, bad OBJ) and then changes nothing.
    std::vector<ObjectResources> load(const Scene &scene);

  private:
    Assets assets_;
    [[nodiscard]] std::shared_ptr<const Mesh> kept_mesh(const Shape &shape) const;

    std::vector<std::pair<Shape, std::shared_ptr<const Mesh>>> meshes_;
    /// Of earlier scenes, as long as someone else holds them: turns taken between scenes build nothing anew.
    std::vector<std::pair<Shape, std::weak_ptr<const Mesh>>> earlier_meshes_;
    std::map<std::string, std::shared_ptr<const Image>> textures_;
};

} // namespace sandbox
