#pragma once

#include "certificate/choice.h"
#include "image/image.h"
#include "render/mesh_buffers.h"
#include "scene/resources.h"
#include "shading/technique.h"

#include <list>
#include <memory>
#include <vector>

namespace sandbox {

/// An object's triangles as the frequency `auto` draws them, part after part. What shows its back alone, where that is
/// culled, is left out.
struct SplitMesh {
    struct Part : certificate::Part {
        TrianglePart triangles;
    };
    Buffer indices;
    std::vector<Part> parts; ///< that have triangles
};

/// Those of the scenes that were drawn last: choosing takes longer than a frame.
class SplitMeshes {
  public:
    /// One per object; chosen now where they are not known. Stays valid until the next call.
    const std::vector<SplitMesh> &of(const Scene &scene, const Technique &technique,
                                     const std::vector<ObjectResources> &resources, Size size);
    /// Would of() return at once?
    [[nodiscard]] bool know(const Scene &scene, const Technique &technique,
                            const std::vector<ObjectResources> &resources, Size size) const;
    /// What certificate::choose() gave for the same.
    void take(const Scene &scene, const Technique &technique, const std::vector<ObjectResources> &resources, Size size,
              const certificate::Choice &choice);
    /// Of many, the ones asked for last stay.
    void forget_unused();

  private:
    struct Held {
        std::weak_ptr<const Mesh> mesh;
        std::weak_ptr<const Image> texture;
        bool has_texture;
        [[nodiscard]] bool gone() const { return mesh.expired() || (has_texture && texture.expired()); }
    };
    struct Entry {
        Scene scene;
        Technique technique;
        double aspect = 1;
        std::vector<Held> held; ///< one per object
        std::vector<SplitMesh> split;
        std::size_t triangles = 0;
    };
    [[nodiscard]] std::list<Entry>::const_iterator find(const Scene &scene, const Technique &technique,
                                                        const std::vector<ObjectResources> &resources, Size size) const;
    std::list<Entry> entries_; ///< the last one asked for last
};

} // namespace sandbox
