#pragma once

#include "image/image.h"

#include <optional>
#include <string_view>

namespace sandbox {

/// The size that the header of a PNG or JPEG file says, before anything is decoded; nothing: decode_image() will say
/// what is wrong with it. A JPEG that is turned may have its sides the other way round.
std::optional<Size> image_size(std::string_view bytes);

} // namespace sandbox
