#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace sandbox {

constexpr std::size_t largest_file = std::size_t{1} << 30; ///< bytes; this program reads nothing larger

/// A regular file, read from its start on in pieces; a pipe or a device may never end. Throws InputError naming it,
/// before anything is read if it has more than `most` bytes.
class FileReader {
  public:
    explicit FileReader(std::filesystem::path path, std::size_t most = largest_file);
    /// When it was opened.
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Puts the next bytes there; returns how many, 0 at the end.
    std::size_t read(std::span<char> bytes);

  private:
    std::filesystem::path path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
    std::size_t most_, size_ = 0, taken_ = 0;
};

/// The whole of a regular file; a pipe or a device may never end. Throws InputError naming it, before anything is read
/// if it has more than `most` bytes.
std::string read_file(const std::filesystem::path &path, std::size_t most = largest_file);

} // namespace sandbox
