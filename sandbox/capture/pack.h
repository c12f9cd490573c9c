#pragma once

#include "capture/grid.h"
#include "capture/picture.h"
#include "image/write_files.h"
#include "scene/assets.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// A picture with all that its sidecar needs, side by side in one folder, so that the folder can go anywhere.
namespace sandbox {

/// What is drawn, with paths such as "./photo.png", and the files that they name, which go into the folder.
struct Pack {
    Scene scene;
    PictureOptions options;
    std::optional<Grid> grid;
    std::vector<OutputFile> files;
};
/// Textures, models and own shading keep their names, unless another file has it: photo-2.png. Names of files built
/// into the program stay. `taken`: the names of other files in the folder. Throws InputError.
Pack pack_of(const Scene &scene, const PictureOptions &options, const std::optional<Grid> &grid, const Assets &assets,
             const std::filesystem::path &folder, const std::set<std::string> &taken);

/// A pack replaces an earlier one of the same files, and nothing else. Throws InputError if the folder holds others.
void refuse_other_files(const std::filesystem::path &folder, const std::set<std::string> &names);

} // namespace sandbox
