#include "scene/resources.h"

#include "image/error.h"
#include "image/file_io.h"
#include "image/image_file.h"
#include "image/plain_text.h"
#include "scene/near_uvs.h"
#include "scene/obj_reader.h"
#include "scene/scene_format.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <utility>

namespace sandbox {
namespace {

/// A kind of built-in files, and where they are below assets/.
struct Kind {
    std::string_view name, folder;
    std::string_view unlisted_folder; ///< of files that are found by name but never suggested; empty: there is none
};
constexpr Kind model_files{"model", "models/", "stability/"}; // broken on purpose: nothing to make a scene from
constexpr Kind texture_files{"texture", "textures/", ""};

/// The bytes of an absolute path, or of the built-in file of that name.
std::string read_named(const Assets &assets, const std::string &name, const Kind &kind) {
    if (std::filesystem::path(name).is_absolute()) {
        return read_file(name);
    }
    for (const std::string_view folder : {kind.folder, kind.unlisted_folder}) {
        if (auto bytes = folder.empty() ? std::nullopt : assets.read(std::string(folder) + name)) {
            return *std::move(bytes);
        }
    }
    std::vector<std::string> known = assets.list(kind.folder);
    for (std::string &path : known) {
        path.erase(0, kind.folder.size());
    }
    throw InputError("{}: no such {}; looked for it beside the scene file (for --set: in the current folder) and among "
                     "the built-in ones ({})",
                     name, kind.name, fmt::join(known, ", "));
}

/// Of an OBJ, its notes go to stderr.
std::shared_ptr<const Mesh> load_mesh(const Assets &assets, const MeshKey &key) {
    const auto *obj = std::get_if<ObjShape>(&key.first);
    std::vector<std::string> notes;
    const auto mesh = std::make_shared<const Mesh>(
        obj != nullptr ? read_obj(read_named(assets, obj->path, model_files), obj->path, notes)
                       : build_mesh(key.first));
    for (const std::string &note : notes) {
        fmt::print(stderr, "note: {}: {}\n", plain_text(obj->path), plain_text(note));
    }
    return with_repeated_uvs(mesh, key.second);
}

MeshKey mesh_key(const Object &object) {
    return {object.mesh, has_texture(object.material) ? object.material.texture_repeat : glm::dvec2(1)};
}

/// Runs `load`; an error of it names the key that asked for it.
template <class Load> auto at_key(std::size_t object, const char *key, const Load &load) {
    try {
        return load();
    } catch (const InputError &error) {
        throw InputError("objects[{}].{}: {}", object, key, error.what());
    }
}

template <class Entries, class Key> auto find_entry(const Entries &entries, const Key &key) {
    return std::ranges::find(
        entries, key, [](const auto &entry) -> const auto & { return entry.first; });
}

} // namespace

Resources::Resources(Assets assets) : assets_(std::move(assets)) {}

std::shared_ptr<const Mesh> Resources::kept_mesh(const MeshKey &key) const {
    if (const auto kept = find_entry(meshes_, key); kept != meshes_.end()) {
        return kept->second;
    }
    const auto earlier = find_entry(earlier_meshes_, key);
    return earlier != earlier_meshes_.end() ? earlier->second.lock() : nullptr;
}

std::vector<ObjectResources> Resources::load(const Scene &scene) {
    // Collected apart and swapped in at the end: a scene that fails changes nothing, one that loads evicts the rest.
    decltype(meshes_) meshes;
    decltype(textures_) textures;
    std::vector<ObjectResources> out;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object &object = scene.objects[i];
        ObjectResources resources;
        resources.window_grid = window_grid_;
        const MeshKey shape = mesh_key(object);
        auto mesh = find_entry(meshes, shape);
        if (mesh == meshes.end()) {
            auto kept = kept_mesh(shape);
            const auto load = [&] { return load_mesh(assets_, shape); };
            meshes.emplace_back(shape, kept ? kept : at_key(i, "mesh.obj", load));
            mesh = std::prev(meshes.end());
        }
        resources.mesh = mesh->second;
        const std::string &name = object.material.texture;
        if (!name.empty()) {
            const std::pair key(name, object.material.texture_color_space);
            auto &texture = textures[key];
            if (!texture) {
                const auto kept = textures_.find(key);
                const auto load = [&] {
                    Image image = decode_image(read_named(assets_, name, texture_files), name);
                    return std::make_shared<const Image>(key.second == ColorSpace::srgb ? decoded_srgb(std::move(image))
                                                                                        : std::move(image));
                };
                texture = kept != textures_.end() ? kept->second : at_key(i, "material.texture", load);
            }
            resources.texture = texture;
        }
        out.push_back(std::move(resources));
    }
    for (const auto &[shape, mesh] : meshes_) {
        if (find_entry(earlier_meshes_, shape) == earlier_meshes_.end()) {
            earlier_meshes_.emplace_back(shape, mesh);
        }
    }
    meshes_ = std::move(meshes);
    std::erase_if(earlier_meshes_, [](const auto &entry) { return entry.second.expired(); });
    textures_ = std::move(textures);
    return out;
}

} // namespace sandbox
