#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sandbox {

/// Changes bytes in place and returns how many there are then, at most the last argument: LLVMFuzzerMutate().
using MutateBytes = std::size_t (*)(std::uint8_t *, std::size_t, std::size_t);

/// Changes a PNG file chunk by chunk, the pixels before they are compressed, and mends every checksum: what comes out
/// gets past the first chunk. Of at most `most` bytes. Nothing where `bytes` is no PNG, or it became too long.
std::optional<std::string> changed_png(std::string_view bytes, unsigned seed, std::size_t most, MutateBytes mutate);

} // namespace sandbox
