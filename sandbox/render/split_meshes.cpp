#include "render/split_meshes.h"

#include <algorithm>

namespace sandbox {
namespace {

/// Of all entries that are kept beside those of A and B: 48 MB.
constexpr std::size_t most_kept_triangles = 4'000'000;
constexpr std::size_t most_entries = 64, least_entries = 2;

SplitMesh split(const Mesh &mesh, const certificate::ObjectChoice &choice) {
    std::vector<glm::uvec3> order;
    order.reserve(mesh.triangles.size());
    std::vector<SplitMesh::Part> parts;
    for (std::size_t part = 0; part < choice.parts.size(); ++part) {
        const std::size_t first = order.size();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (choice.part_of[t] == part) {
                order.push_back(mesh.triangles[t]);
            }
        }
        if (order.size() > first) {
            parts.push_back({choice.parts[part], {0, first, order.size() - first}});
        }
    }
    SplitMesh made{make_index_buffer(order), std::move(parts)};
    for (SplitMesh::Part &part : made.parts) {
        part.triangles.indices = made.indices.id();
    }
    return made;
}

Technique as_chosen(Technique technique) {
    technique.program = Program::specialised; // changes no bound
    return technique;
}

} // namespace

std::list<SplitMeshes::Entry>::const_iterator SplitMeshes::find(const Scene &scene, const Technique &technique,
                                                                const std::vector<ObjectResources> &resources,
                                                                Size size) const {
    return std::ranges::find_if(entries_, [&, asked = as_chosen(technique)](const Entry &entry) {
        return entry.aspect == aspect_of(size) && entry.technique == asked && entry.scene == scene &&
               std::ranges::equal(entry.held, resources, [](const Held &held, const ObjectResources &now) {
                   return held.mesh.lock() == now.mesh && held.texture.lock() == now.texture;
               });
    });
}

bool SplitMeshes::know(const Scene &scene, const Technique &technique, const std::vector<ObjectResources> &resources,
                       Size size) const {
    return find(scene, technique, resources, size) != entries_.end();
}

const std::vector<SplitMesh> &SplitMeshes::of(const Scene &scene, const Technique &technique,
                                              const std::vector<ObjectResources> &resources, Size size) {
    const auto found = find(scene, technique, resources, size);
    if (found != entries_.end()) {
        entries_.splice(entries_.end(), entries_, found);
    } else {
        take(scene, technique, resources, size, certificate::choose(scene, resources, technique, aspect_of(size)));
    }
    return entries_.back().split;
}

void SplitMeshes::take(const Scene &scene, const Technique &technique, const std::vector<ObjectResources> &resources,
                       Size size, const certificate::Choice &choice) {
    entries_.remove_if([](const Entry &entry) { return std::ranges::any_of(entry.held, &Held::gone); });
    std::list<Entry> made(1);
    Entry &entry = made.front();
    entry.scene = scene;
    entry.technique = as_chosen(technique);
    entry.aspect = aspect_of(size);
    for (std::size_t i = 0; i < resources.size(); ++i) {
        const Mesh &mesh = *resources[i].mesh;
        entry.held.push_back({resources[i].mesh, resources[i].texture, resources[i].texture != nullptr});
        entry.split.push_back(split(mesh, choice.objects[i]));
        entry.triangles += mesh.triangles.size();
    }
    entries_.splice(entries_.end(), made);
}

void SplitMeshes::forget_unused() {
    std::size_t triangles = 0;
    for (const Entry &kept : entries_) {
        triangles += kept.triangles;
    }
    while (entries_.size() > least_entries && (triangles > most_kept_triangles || entries_.size() > most_entries)) {
        triangles -= entries_.front().triangles;
        entries_.pop_front();
    }
}

} // namespace sandbox
