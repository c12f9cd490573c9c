#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace sandbox {

constexpr std::size_t largest_file = std::size_t{1} << 30; ///< bytes; this program reads nothing larger

/// The whole of a regular file; a pipe or a device may never end. Throws InputError naming it, before anything is read
/// if it has more than `most` bytes.
std::string read_file(const std::filesystem::path &path, std::size_t most = largest_file);

} // namespace sandbox
