#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace sandbox {

/// A model file as objects of a scene.
struct ModelObjects {
    std::vector<Object> objects;    ///< one for each material that faces of it have; each holds its mesh
    std::vector<std::string> notes; ///< what to tell people of the file, one sentence each
    glm::dvec3 low{0}, high{0};     ///< bounds in object space
    std::string why_two_sided;      ///< why backs of its triangles are seen and to be lit; empty: they are not
};

/// `like` is what each object is like but for its mesh, its name and what its material says otherwise (mtl_reader.h): a
/// file without materials gives one such object. Libraries are looked for beside the model; one that cannot be read is
/// told of in a note, and so are a material that none of them has, and a texture that cannot be one or has no texture
/// coordinates to go by, which are left out. Throws InputError.
ModelObjects objects_of_model(const std::filesystem::path &path, const Object &like);

} // namespace sandbox
