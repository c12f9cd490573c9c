#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace sandbox {

struct OutputFile {
    std::filesystem::path path;
    std::string bytes;
};
/// Writes to temporary names beside the paths and renames: all of them whole, or everything stays as it was; an
/// interrupt waits. Devices are written in place, before anything is renamed. Throws InputError naming the path.
void write_files(std::span<const OutputFile> files);
void write_file(const std::filesystem::path &path, std::string_view bytes);

/// Throws InputError, as write_file() would, unless a file can be written there: so that no work is lost. Changes
/// nothing.
void check_writable(const std::filesystem::path &path);

} // namespace sandbox
