#include "scene/model_objects.h"

#include "image/error.h"
#include "image/file_io.h"
#include "image/image_file.h"
#include "image/jpeg.h"
#include "scene/mesh.h"
#include "scene/mesh_backs.h"
#include "scene/mtl_reader.h"
#include "scene/obj_reader.h"
#include "scene/scene_format.h"
#include "scene/scene_read.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <map>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

namespace sandbox {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t largest_library = std::size_t{16} << 20; ///< bytes

using Materials = std::map<std::string, Material, std::less<>>;

bool is_there(const fs::path &path) {
    std::error_code ignored;
    return fs::status(path, ignored).type() != fs::file_type::not_found;
}

/// A path as a model's files have it, which may be written with the other slash.
fs::path beside(const fs::path &folder, std::string name) {
    if (is_there(folder / name)) {
        return folder / name;
    }
    std::ranges::replace(name, '\\', '/');
    return folder / name;
}

bool ends_as_library(std::string_view word) {
    constexpr std::string_view ending = ".mtl";
    return word.size() >= ending.size() &&
           std::ranges::equal(word.substr(word.size() - ending.size()), ending, {},
                              [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
}

/// The names of a mtllib line: one that is a file's, or as many as end in .mtl, each with the blanks in it.
std::vector<std::string> library_names(const fs::path &folder, const std::string &line) {
    if (is_there(folder / line)) {
        return {line};
    }
    std::vector<std::string> names;
    std::string_view rest = line;
    std::size_t end = 0;
    while (end < rest.size()) {
        end = std::min(rest.find(' ', end + 1), rest.size());
        if (end == rest.size() || ends_as_library(rest.substr(0, end))) {
            names.emplace_back(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            end = 0;
        }
    }
    return names;
}

/// Why a file cannot be a texture; empty: it may be one, as its first bytes say.
std::string why_no_texture(const fs::path &path) {
    if (!is_there(path)) {
        return fmt::format("no such file in {}", path.parent_path().string());
    }
    try {
        std::array<char, 16> start{};
        const std::size_t count = FileReader(path).read(start);
        const std::string_view bytes(start.data(), count);
        return bytes.starts_with(png_signature) || bytes.starts_with(jpeg_signature) ? "" : "neither a PNG nor a JPEG";
    } catch (const InputError &error) {
        return error.what();
    }
}

class ModelReader {
  public:
    ModelReader(const fs::path &path, const Object &like)
        : path_(checked_path(fs::absolute(path).lexically_normal())), given_(path), like_(like) {
        like_.materials = MaterialsOf::scene;
    }

    ModelObjects read() {
        ObjModel model = read_obj_model_file(given_, out_.notes);
        judge_backs(model);
        const bool has_names = std::ranges::any_of(model.parts, [](const auto &part) { return !part.usemtl.empty(); });
        const Materials materials = has_names ? read_libraries(model.libraries) : Materials{};
        for (ObjModel::Part &part : model.parts) {
            add_object(std::move(part), materials, model.parts.size() > 1);
        }
        return std::move(out_);
    }

  private:
    fs::path path_, given_;
    Object like_;
    ModelObjects out_;

    /// Of the whole: where its materials meet, its parts are open. A model most of whose normals stand on the backs of
    /// its triangles is lit by those normals.
    void judge_backs(const ObjModel &model) {
        std::size_t against = 0;
        Mesh all;
        all.bounds = model.parts.front().mesh.bounds;
        for (const auto &[usemtl, mesh] : model.parts) {
            against += mesh.against_normals;
            all.bounds = {glm::min(all.bounds.low, mesh.bounds.low), glm::max(all.bounds.high, mesh.bounds.high)};
        }
        std::tie(out_.low, out_.high) = std::pair(all.bounds.low, all.bounds.high);
        std::size_t triangles = 0;
        for (const auto &[usemtl, mesh] : model.parts) {
            triangles += mesh.triangles.size();
            if (model.parts.size() > 1) {
                const auto first = static_cast<unsigned>(all.positions.size());
                all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
                std::ranges::transform(mesh.triangles, std::back_inserter(all.triangles),
                                       [&](const glm::uvec3 &t) { return t + first; });
            }
        }
        const BacksSeen seen = backs_seen(model.parts.size() > 1 ? all : model.parts.front().mesh);
        if (seen != BacksSeen::none && against <= triangles / 2) {
            out_.why_two_sided = seen == BacksSeen::open ? "it does not enclose a volume" : "it is wound inside out";
        }
    }

    Materials read_libraries(const std::vector<std::string> &lines) {
        const fs::path folder = path_.parent_path();
        Materials all;
        for (const std::string &line : lines) {
            for (const std::string &name : library_names(folder, line)) {
                read_library(beside(folder, name), name, all);
            }
        }
        return all;
    }

    void read_library(const fs::path &path, const std::string &name, Materials &all) {
        std::string why = is_there(path) ? "" : fmt::format("no such file in {}", path.parent_path().string());
        std::unique_ptr<FileReader> file;
        try {
            file = why.empty() ? std::make_unique<FileReader>(path, largest_library) : nullptr;
        } catch (const InputError &error) {
            why = error.what();
        }
        if (file == nullptr) {
            out_.notes.push_back(fmt::format("mtllib {}: {}; its materials are as the scene has them", name, why));
            return;
        }
        std::vector<std::string> notes;
        Materials read =
            read_mtl([&](std::span<char> bytes) { return file->read(bytes); }, path.string(), like_.material, notes);
        for (const std::string &note : notes) {
            out_.notes.push_back(fmt::format("{}: {}", name, note));
        }
        for (auto &[material, values] : read) {
            find_texture(path.parent_path(), fmt::format("{}: {}: map_Kd {}", name, material, values.texture), values);
        }
        all.merge(read);
    }

    /// Makes the path of a library's texture absolute, or leaves it out.
    void find_texture(const fs::path &folder, const std::string &where, Material &material) {
        if (material.texture == like_.material.texture) {
            return;
        }
        fs::path path = beside(folder, material.texture);
        if (!is_there(path) && is_there(beside(path_.parent_path(), material.texture))) {
            path = beside(path_.parent_path(), material.texture); // of a library in another folder
        }
        path = path.lexically_normal();
        if (const std::string why = why_no_texture(path); !why.empty()) {
            out_.notes.push_back(fmt::format("{}: {}; drawn without it", where, why));
            material.texture = "";
            material.texture_modulates_specular = like_.material.texture_modulates_specular;
            return;
        }
        material.texture = checked_path(path);
        material.checker.reset();
    }

    void add_object(ObjModel::Part part, const Materials &materials, bool one_of_many) {
        Object object = like_;
        if (const auto found = materials.find(part.usemtl); found != materials.end()) {
            object.material = found->second;
        } else if (!part.usemtl.empty()) {
            out_.notes.push_back(
                fmt::format("usemtl {}: no library of it has this material; it is as the scene has it", part.usemtl));
        }
        if (has_texture(object.material) && part.mesh.uvs.empty()) {
            out_.notes.push_back(fmt::format(
                "usemtl {}: its faces have no texture coordinates (vt); drawn without its texture", part.usemtl));
            object.material.texture = "";
        }
        ObjShape shape{path_.string()};
        if (one_of_many) {
            shape.usemtl = part.usemtl;
            object.name = part.usemtl.empty() ? like_.name : fmt::format("{} ({})", like_.name, part.usemtl);
        }
        shape.mesh = std::make_shared<const Mesh>(std::move(part.mesh));
        object.mesh = std::move(shape);
        out_.objects.push_back(std::move(object));
    }
};

} // namespace

ModelObjects objects_of_model(const fs::path &path, const Object &like) { return ModelReader(path, like).read(); }

} // namespace sandbox
