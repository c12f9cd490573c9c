#pragma once

#include <cstddef>
#include <string_view>

namespace sandbox {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// Whether a chunk stands before the picture's data; no checksum is looked at.
bool has_png_chunk(std::string_view bytes, std::string_view type);

/// Whether another chunk stands within the picture's data, which must be in one run.
bool png_data_is_split(std::string_view bytes);

/// The end of the picture's data, which a decoder may not reach: the checksum of all of it (Adler-32). Inflates up to
/// `most` bytes. Throws InputError; `name` is used in messages.
void check_png_data(std::string_view bytes, std::size_t most, std::string_view name);

} // namespace sandbox
