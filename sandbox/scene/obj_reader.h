#pragma once

#include "scene/mesh.h"
#include "scene/obj_text.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// What a model file holds.
struct ObjModel {
    struct Part {
        std::string usemtl; ///< the name that its faces stand under; empty: before any
        Mesh mesh;
    };
    std::vector<Part> parts;            ///< each with a triangle, in the order in which the names come
    std::vector<std::string> libraries; ///< what stands behind each mtllib
};

/// Reads v, vt, vn, f, s, usemtl, mtllib of a Wavefront OBJ text (obj_text.h says how a text is made of lines). Indices
/// may name what comes later. How faces become a mesh: obj_mesh.h. v may have a colour behind its position: where one
/// is not finite, or below 0 or above 1e6, it counts as white. A mesh with no triangle is refused, and more than
/// most_triangles are.
/// `name` is used in messages: `bunny.obj:12: expected ...`. `notes` gets what to tell people of it: what was mended or
/// left out (lines, points, curves), one sentence each. Throws InputError.
Mesh read_obj(std::string_view text, std::string_view name, std::vector<std::string> &notes);
/// Of a file, of which it holds but a block at a time.
Mesh read_obj_file(const std::filesystem::path &path, std::vector<std::string> &notes);
/// With the faces of each material apart.
ObjModel read_obj_model(TextSource source, std::string_view name, std::vector<std::string> &notes);
ObjModel read_obj_model_file(const std::filesystem::path &path, std::vector<std::string> &notes);
/// Says the notes of the file `name` on stderr.
void say_notes(std::string_view name, const std::vector<std::string> &notes);
/// For who tells nobody.
Mesh read_obj(std::string_view text, std::string_view name);

} // namespace sandbox
