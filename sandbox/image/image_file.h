#pragma once

#include "image/file_io.h"
#include "image/image.h"
#include "image/pfm.h"
#include "image/png.h"
#include "image/write_files.h"

#include <string_view>

namespace sandbox {

/// A PNG or JPEG, told apart by their first bytes; 8-bit values / 255, no sRGB decoding. `name` is used in messages.
/// Throws InputError; refuses more than max_image_side pixels a side.
Image decode_image(std::string_view bytes, std::string_view name);

} // namespace sandbox
