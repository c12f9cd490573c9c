#include "scene/assets.h"

#include "image/error.h"
#include "image/file_io.h"
#include "scene/embedded.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sandbox {
namespace fs = std::filesystem;

Assets::Assets(std::string root, fs::path folder) : root_(std::move(root)), folder_(std::move(folder)) {
    std::error_code failed;
    if (!folder_.empty() && !fs::is_directory(folder_, failed)) {
        throw InputError("--{} {}: expected a folder{}", root_, folder_.string(),
                         failed ? fmt::format(" ({})", failed.message()) : "");
    }
}

std::optional<std::string> Assets::read(std::string_view path) const {
    if (!folder_.empty()) {
        std::error_code ignored;
        const fs::path file = folder_ / path;
        const fs::file_type type = fs::status(file, ignored).type(); // none: it may not be looked at, and that is said
        const bool missing = type == fs::file_type::not_found || type == fs::file_type::directory;
        return missing ? std::nullopt : std::optional(read_file(file));
    }
    const std::string full = root_ + "/" + std::string(path);
    const auto files = embedded_files();
    const auto found = std::ranges::find(files, full, &EmbeddedFile::path);
    return found != files.end() ? std::optional(std::string(found->bytes)) : std::nullopt;
}

std::vector<std::string> Assets::list(std::string_view prefix) const {
    std::vector<std::string> paths;
    if (!folder_.empty()) {
        for (const auto &entry : fs::recursive_directory_iterator(folder_)) {
            if (entry.is_regular_file()) {
                paths.push_back(entry.path().lexically_relative(folder_).generic_string());
            }
        }
    } else {
        for (const EmbeddedFile &file : embedded_files()) {
            if (file.path.starts_with(root_ + "/")) {
                paths.emplace_back(file.path.substr(root_.size() + 1));
            }
        }
    }
    std::erase_if(paths, [&](const std::string &path) { return !path.starts_with(prefix); });
    std::ranges::sort(paths);
    return paths;
}

} // namespace sandbox
