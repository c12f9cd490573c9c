#pragma once

#include "capture/picture.h"
#include "image/image.h"
#include "reference/parallel.h"
#include "scene/motion.h"
#include "shading/technique.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Many pictures of one scene in one: techniques down, values of a setting across.
namespace sandbox {

constexpr std::size_t most_cells = 64;

/// A setting and the values that it takes in turn.
struct Sweep {
    std::string path; ///< "objects[0].material.shininess"
    std::vector<std::string> values;
    bool operator==(const Sweep &) const = default;
};
/// "PATH=v1,v2,...": a comma within [] or {} belongs to its value. Throws InputError saying what was expected.
Sweep parse_sweep(std::string_view text);

struct Grid {
    std::vector<Technique> techniques; ///< from the top
    Sweep sweep;
    std::filesystem::path folder{}; ///< where textures and models of the sweep are looked for; empty: the current one
    bool operator==(const Grid &) const = default;
};
/// The sidecar of a grid: that of one cell (sidecar_text()) with the keys rows, techniques, and sweep,
/// "PATH=v1,v2,...". Paths are relative to `folder`, where it will stand, if they can be (empty: as they are).
std::string grid_text(std::string_view cell, const Grid &grid, const std::filesystem::path &folder = {});
/// The grid of a sidecar in `folder`; nothing if `text` is of one picture, or no sidecar. Throws InputError if a key is
/// wrong.
std::optional<Grid> grid_of(std::string_view text, std::string_view name, const std::filesystem::path &folder = {});

/// The file that a value of a sweep over textures or models names, absolute; a bare name that is no file there may be a
/// built-in one.
std::string file_of_value(const Grid &grid, std::string_view value);

/// A picture for row and column, as large as every other.
using DrawCell = std::function<ByteImage(std::size_t row, std::size_t column)>;
/// The cells, each `cell` large, under a strip with `columns` and each row under one with its name. Throws InputError
/// if there are none or more than most_cells, or if they are too large together.
ByteImage grid_picture(std::span<const std::string> rows, std::span<const std::string> columns, Size cell,
                       const DrawCell &draw);

/// `values` numbers evenly over those that the motion goes through, of which at least 2 differ; whole ones stay whole.
/// Throws InputError for a motion that is of no number of the scene.
Sweep sweep_of(const Motion &motion, const Scene &scene, int values);

/// One technique's cell of a grid: a single view of the options' size.
PictureOptions cell_options(PictureOptions options, const Technique &technique);
/// Techniques down, values across, in cells of the options' size; A's mesh factor is the first row's, B's that of the
/// others. `name` is used in messages. Throws InputError as with_settings() and grid_picture() do, Cancelled.
ByteImage draw_grid(const Scene &scene, const Grid &grid, const PictureOptions &options, const Painters &painters,
                    std::string_view name, const Progress &progress);

} // namespace sandbox
