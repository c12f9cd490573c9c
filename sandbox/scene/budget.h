#pragma once

#include "image/image.h"
#include "scene/mesh.h"

#include <cstddef>
#include <string>
#include <string_view>

/// What a scene may take, so that all of it together leaves a machine of 4 GB its memory: refused before it is taken.
namespace sandbox {

/// Of the distinct textures of a scene, decoded (16 bytes a pixel). OpenGL holds as much again, and while one is
/// uploaded there is a third copy: 1.5 GB.
constexpr std::size_t most_texture_bytes = std::size_t{512} << 20;
/// Of the distinct meshes of a scene. About 50 bytes each, another 40 in OpenGL's buffers, 110 there if shaded flat.
constexpr std::size_t most_triangles = 10'000'000;
/// Of a picture (check_size(): 64 Mpixel) that adds up samples in doubles, which takes 75 bytes a pixel: 1.2 GB.
constexpr std::size_t most_sampled_pixels = std::size_t{16} << 20;
/// Throws InputError if a picture that adds up samples is larger.
void check_sampled(Size size);

/// Counts what the objects of a scene take. Throws InputError that names the object and the figures.
class SceneBudget {
  public:
    /// `object` as messages call it: object_name(). Of a texture not counted yet.
    void add_texture(std::string_view object, std::string_view texture, Size size);
    /// Of a mesh not counted yet.
    void add_triangles(std::string_view object, std::size_t triangles);

  private:
    std::size_t texture_bytes_ = 0, triangles_ = 0;
};

/// objects[3] ("floor")
std::string object_name(const Scene &scene, std::size_t index);

/// How many triangles build_mesh() makes of a built-in shape, or a few more; 0 of an ObjShape.
std::size_t triangles_of(const Shape &shape);

} // namespace sandbox
