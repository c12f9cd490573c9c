#pragma once

#include <optional>
#include <string_view>

namespace sandbox {

/// Where an upright picture's pixel stands in the file: in column x of the file, or, transposed, in row x; counted from
/// the right or from the bottom of the file where said.
struct Orientation {
    bool transposed = false, from_right = false, from_bottom = false;
};

/// How a camera was held: tag 0x0112 of the EXIF data (TIFF 6.0, Exif 2.3) in a JPEG's APP1 segment; null: it holds
/// other data. Damaged or without the tag: as the file stands, for no pixel needs it.
std::optional<Orientation> exif_orientation(std::string_view segment);

} // namespace sandbox
