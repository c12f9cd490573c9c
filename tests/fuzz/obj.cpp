#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "scene/obj_reader.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

template <class Vector> bool is_finite(const Vector &vector) {
    for (int i = 0; i < Vector::length(); ++i) {
        if (!std::isfinite(vector[i])) {
            return false;
        }
    }
    return true;
}

void held_mesh(const Mesh &mesh) {
    const std::size_t vertices = mesh.positions.size();
    held(!mesh.triangles.empty(), "a mesh has a triangle");
    held(mesh.normals.size() == vertices, "a normal a vertex");
    held(mesh.uvs.empty() || mesh.uvs.size() == vertices, "a texture coordinate a vertex, or none");
    held(mesh.file_normals.empty() || mesh.file_normals.size() == vertices, "a file's normal a vertex, or none");
    for (const glm::uvec3 &triangle : mesh.triangles) {
        held(triangle.x < vertices && triangle.y < vertices && triangle.z < vertices, "triangles name vertices");
    }
    for (const glm::dvec3 &position : mesh.positions) {
        held(is_finite(position), "positions are finite");
    }
    for (const glm::dvec2 &uv : mesh.uvs) {
        held(is_finite(uv), "texture coordinates are finite");
    }
    for (const glm::dvec3 &normal : mesh.normals) {
        held(is_finite(normal) && std::abs(glm::length(normal) - 1) < 1e-9, "normals are unit"); // some roundings
    }
}

} // namespace

void check_obj(std::string_view bytes) {
    std::vector<std::string> notes;
    if (const auto mesh = accepted([&] { return read_obj(bytes, "a.obj", notes); })) {
        held_mesh(*mesh);
    }
    held(notes.size() < 20, fmt::format("{} notes", notes.size()));
    for (const std::string &note : notes) {
        held(note.size() < 500, "a note is short");
    }
}

std::vector<std::string> obj_seeds() {
    std::vector<std::string> seeds = files_in("assets/stability", ".obj");
    seeds.insert(
        seeds.end(),
        {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1 4/2/1\n",
         "\xEF\xBB\xBFo a\r\nv 0 0 0\r\nv 2 0 0\r\nv 1 .5 0\r\nv 1 2 0\r\ns 1\r\nf -4 -3 \\\r\n-2 -1\r\ns off\r\n",
         "f 1//1 2//1 3//1\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1e-30\nl 1 2\np 3\nusemtl x\n",
         "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 4 0\nv 3 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\nf 1 2 3 4 5 6 7 8\n"});
    return seeds;
}

} // namespace sandbox
