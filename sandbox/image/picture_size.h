#pragma once

#include "image/image.h"

#include <string_view>

namespace sandbox {

/// Throws InputError unless both sides are 1 to 16384 and there are at most 64 Mpixel.
void check_size(Size size);

/// WIDTHxHEIGHT, checked. Throws InputError.
Size parse_size(std::string_view text);

} // namespace sandbox
