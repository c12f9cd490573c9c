#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// The built-in files, by their path below assets/ or shaders/: the copies inside the executable, or those of a folder
/// on disk instead (--assets DIR, --shaders DIR).
class Assets {
  public:
    /// `root` is "assets" or "shaders"; `folder` empty: the copies inside the executable.
    explicit Assets(std::string root, std::filesystem::path folder = {});

    /// The whole file, or nothing if there is none, e.g. read("scenes/three-point-lights.json").
    [[nodiscard]] std::optional<std::string> read(std::string_view path) const;
    /// Paths that begin with `prefix`, sorted.
    [[nodiscard]] std::vector<std::string> list(std::string_view prefix) const;
    /// Where the files are read from; empty: inside the executable.
    [[nodiscard]] const std::filesystem::path &folder() const { return folder_; }

  private:
    std::string root_;
    std::filesystem::path folder_;
};

} // namespace sandbox
