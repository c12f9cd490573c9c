#include "scene/resources.h"

#include "image/error.h"
#include "image/file_io.h"
#include "image/image_file.h"
#include "image/image_size.h"
#include "image/plain_text.h"
#include "scene/budget.h"
#include "scene/near_uvs.h"
#include "scene/obj_reader.h"
#include "scene/scene_format.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
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

/// The meshes of models by path and usemtl.
using ObjParts = std::map<std::string, std::map<std::string, std::shared_ptr<const Mesh>>>;

/// The bytes of an absolute path, or of the built-in file of that name.
std::string read_named(const Assets &assets, const std::string &name, const Kind &kind, const LookedIn &looked) {
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
    throw InputError("{}: no such {}; looked for it {}among the built-in ones ({})", name, kind.name,
                     looked.folder.empty() ? "" : fmt::format("in {} and ", plain_text(looked.folder)),
                     fmt::join(known, ", "));
}

/// The faces of one material, of a file whose `parts` are those read already. Notes go to stderr.
std::shared_ptr<const Mesh> load_part(const ObjShape &obj, ObjParts &parts) {
    auto &meshes = parts[obj.path];
    if (meshes.empty()) {
        std::vector<std::string> notes;
        ObjModel model = read_obj_model_file(obj.path, notes);
        say_notes(obj.path, notes);
        for (ObjModel::Part &part : model.parts) {
            meshes.emplace(part.usemtl, std::make_shared<const Mesh>(std::move(part.mesh)));
        }
    }
    const auto found = meshes.find(*obj.usemtl);
    if (found == meshes.end()) {
        std::string names; // Clang 14 cannot take std::views::keys
        for (const auto &[name, mesh] : meshes) {
            names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
        }
        throw InputError("{}: no faces under usemtl \"{}\"; it has {}", obj.path, *obj.usemtl, names);
    }
    return found->second;
}

std::shared_ptr<const Mesh> load_obj(const Assets &assets, const ObjShape &obj, ObjParts &parts,
                                     const LookedIn &looked) {
    if (obj.mesh != nullptr) {
        return obj.mesh;
    }
    const bool on_disk = std::filesystem::path(obj.path).is_absolute();
    if (obj.usemtl && on_disk) {
        return load_part(obj, parts);
    }
    if (obj.usemtl) {
        throw InputError("{}: usemtl needs a file beside the scene", obj.path);
    }
    std::vector<std::string> notes;
    auto mesh = std::make_shared<const Mesh>(
        on_disk ? read_obj_file(obj.path, notes)
                : read_obj(read_named(assets, obj.path, model_files, looked), obj.path, notes));
    say_notes(obj.path, notes);
    return mesh;
}

/// A key holds no mesh: it would keep it for as long as it stands in a list.
MeshKey mesh_key(const Object &object) {
    MeshKey key{object.mesh, has_texture(object.material) ? object.material.texture_repeat : glm::dvec2(1)};
    if (auto *obj = std::get_if<ObjShape>(&key.first)) {
        obj->mesh = nullptr;
    }
    return key;
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

/// Before the first of them is built.
void refuse_too_many_triangles(const Scene &scene) {
    std::size_t most = 0; // where every mesh is another one
    for (const Object &object : scene.objects) {
        most += triangles_of(object.mesh);
    }
    if (most <= most_triangles) {
        return;
    }
    SceneBudget budget;
    std::vector<const Shape *> counted;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Shape &shape = scene.objects[i].mesh;
        if (std::ranges::none_of(counted, [&](const Shape *other) { return *other == shape; })) {
            counted.push_back(&shape);
            budget.add_triangles(object_name(scene, i), triangles_of(shape));
        }
    }
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

/// What load() collects, apart from what is kept: a scene that fails changes nothing.
struct Resources::Loading {
    const Scene &scene;
    decltype(meshes_) meshes;
    decltype(textures_) textures;
    ObjParts parts;
    SceneBudget budget;
};

std::shared_ptr<const Mesh> Resources::mesh_of(std::size_t i, Loading &now) const {
    const Object &object = now.scene.objects[i];
    const MeshKey key = mesh_key(object);
    if (const auto mesh = find_entry(now.meshes, key); mesh != now.meshes.end()) {
        return mesh->second;
    }
    const auto *obj = std::get_if<ObjShape>(&object.mesh);
    auto mesh = kept_mesh(key);
    if (obj != nullptr && obj->mesh != nullptr && key.second == glm::dvec2(1) && mesh != obj->mesh) {
        mesh = nullptr; // read anew
    }
    if (obj == nullptr) {
        now.budget.add_triangles(object_name(now.scene, i), triangles_of(object.mesh));
    }
    if (mesh == nullptr) {
        mesh = obj == nullptr
                   ? std::make_shared<const Mesh>(build_mesh(object.mesh))
                   : at_key(i, "mesh.obj", [&] { return load_obj(assets_, *obj, now.parts, now.scene.looked_in); });
        mesh = with_repeated_uvs(mesh, key.second);
    }
    if (obj != nullptr) {
        now.budget.add_triangles(object_name(now.scene, i), mesh->triangles.size());
    }
    return now.meshes.emplace_back(key, std::move(mesh)).second;
}

std::shared_ptr<const Image> Resources::texture_of(std::size_t i, Loading &now) const {
    const Material &material = now.scene.objects[i].material;
    auto &texture = now.textures[{material.texture, material.texture_color_space}];
    if (texture != nullptr) {
        return texture;
    }
    const std::string object = object_name(now.scene, i);
    const auto kept = textures_.find({material.texture, material.texture_color_space});
    if (kept != textures_.end()) {
        now.budget.add_texture(object, material.texture, kept->second->size);
        return texture = kept->second;
    }
    const std::string bytes = at_key(i, "material.texture", [&] {
        return read_named(assets_, material.texture, texture_files, now.scene.looked_in);
    });
    if (const auto size = image_size(bytes)) {
        now.budget.add_texture(object, material.texture, *size);
    }
    Image image = at_key(i, "material.texture", [&] { return decode_image(bytes, material.texture); });
    texture = std::make_shared<const Image>(
        material.texture_color_space == ColorSpace::srgb ? decoded_srgb(std::move(image)) : std::move(image));
    return texture;
}

std::vector<ObjectResources> Resources::load(const Scene &scene) {
    refuse_too_many_triangles(scene);
    Loading now{scene, {}, {}, {}, {}};
    std::vector<ObjectResources> out;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        ObjectResources resources;
        resources.window_grid = window_grid_;
        resources.mesh = mesh_of(i, now);
        if (const Material &material = scene.objects[i].material; has_texture(material)) {
            resources.texture = texture_of(i, now);
            const auto *obj = std::get_if<ObjShape>(&scene.objects[i].mesh);
            const bool is_new = !textures_.contains({material.texture, material.texture_color_space}) ||
                                kept_mesh(mesh_key(scene.objects[i])) == nullptr;
            if (obj != nullptr && resources.mesh->uvs.empty() && is_new) {
                say_notes(obj->path, {fmt::format("objects[{}]: no texture coordinates (vt); all of it has the colour "
                                                  "of the texture's corner",
                                                  i)});
            }
        }
        out.push_back(std::move(resources));
    }
    for (const auto &[shape, mesh] : meshes_) {
        if (find_entry(earlier_meshes_, shape) == earlier_meshes_.end()) {
            earlier_meshes_.emplace_back(shape, mesh);
        }
    }
    meshes_ = std::move(now.meshes);
    std::erase_if(earlier_meshes_, [](const auto &entry) { return entry.second.expired(); });
    textures_ = std::move(now.textures);
    return out;
}

} // namespace sandbox
