#include "render/split_meshes.h"

#include "certificate/choice.h"

#include <algorithm>

namespace sandbox {
namespace {

/// Of all entries that are kept: 48 MB.
constexpr std::size_t most_triangles = 4'000'000;
constexpr std::size_t most_entries = 64;

SplitMesh split(const Mesh &mesh, const certificate::ObjectChoice &choice) {
    std::vector<glm::uvec3> order;
    order.reserve(mesh.triangles.size());
    SplitMesh made;
    for (const std::uint8_t wanted : {certificate::proved, certificate::per_pixel}) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (choice.per_vertex[t] == wanted) {
                order.push_back(mesh.triangles[t]);
            }
        }
        (wanted == certificate::proved ? made.per_vertex : made.per_pixel) = order.size() - made.per_vertex;
    }
    made.indices = make_index_buffer(order);
    return made;
}

bool same(const std::weak_ptr<const Mesh> &kept, const ObjectResources &now) { return kept.lock() == now.mesh; }

} // namespace

const std::vector<SplitMesh> &SplitMeshes::of(const Scene &scene, const Technique &technique,
                                              const std::vector<ObjectResources> &resources, Size size) {
    const double aspect = aspect_of(size);
    Technique asked = technique;
    asked.program = Program::specialised; // changes no bound
    const auto found = std::ranges::find_if(entries_, [&](const Entry &entry) {
        return entry.aspect == aspect && entry.technique == asked && entry.scene == scene &&
               std::ranges::equal(entry.meshes, resources, same);
    });
    if (found != entries_.end()) {
        return found->split;
    }
    Entry entry{scene, asked, aspect, {}, {}};
    const certificate::Choice choice = certificate::choose(scene, resources, asked, asked.tolerance, aspect);
    for (std::size_t i = 0; i < resources.size(); ++i) {
        const Mesh &mesh = *resources[i].mesh;
        entry.meshes.emplace_back(resources[i].mesh);
        entry.split.push_back(split(mesh, choice.objects[i]));
        entry.triangles += mesh.triangles.size();
    }
    entries_.push_back(std::move(entry));
    std::size_t kept = 0;
    const auto oldest = std::find_if(entries_.rbegin() + 1, entries_.rend(), [&](const Entry &earlier) {
        kept += earlier.triangles;
        return kept + entries_.back().triangles > most_triangles;
    });
    entries_.erase(entries_.begin(), oldest.base());
    if (entries_.size() > most_entries) {
        entries_.pop_front();
    }
    return entries_.back().split;
}

} // namespace sandbox
