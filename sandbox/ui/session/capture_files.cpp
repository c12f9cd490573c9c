#include "ui/session/capture_files.h"

#include "capture/sidecar.h"
#include "image/error.h"

#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace sandbox {

namespace {

namespace fs = std::filesystem;

/// Scene names may be anything; file names hold letters, digits, dots and dashes.
std::string file_stem(const std::string &name) {
    std::string stem;
    for (const char c : name) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
        stem += plain ? c : '-';
    }
    return stem.empty() || stem.front() == '.' ? "scene" + stem : stem;
}

/// scene-007.png
std::string numbered(const std::string &name, int number, const char *ending) {
    return fmt::format("{}-{:03}{}", file_stem(name), number, ending);
}

} // namespace

PictureOptions picture_options(const Session &session, Size each) {
    const Document &document = session.document;
    PictureOptions options;
    options.layout = session.view.layout;
    const bool single_right = options.layout == Layout::single && session.view.show_right;
    options.left = single_right ? document.right : document.left;
    options.right = document.right;
    options.textbook_left = !single_right && document.left_is_textbook();
    options.size = options.layout == Layout::side_by_side ? Size{each.width * 2, each.height} : each;
    options.display = document.display;
    options.exposure = document.exposure;
    options.gain = session.view.gain;
    options.divider = static_cast<double>(session.view.divider);
    options.labels = true;
    return options;
}

fs::path free_name(const fs::path &folder, const std::string &name) {
    for (int number = 1; number < 100000; ++number) {
        fs::path path = folder / numbered(name, number, ".png");
        if (!fs::exists(path) && !fs::exists(sidecar_path(path))) {
            return path;
        }
    }
    throw InputError(folder.string() + ": holds too many captures of " + name);
}

fs::path new_folder(const fs::path &folder, const std::string &name) {
    for (int number = 1; number < 100000; ++number) {
        fs::path path = folder / numbered(name, number, "");
        std::error_code error;
        if (fs::create_directory(path, error)) {
            return path;
        }
        if (error && !fs::exists(path)) {
            throw InputError("cannot make the folder " + path.string() + ": " + error.message());
        }
    }
    throw InputError(folder.string() + ": holds too many folders of " + name);
}

fs::path capture_folder() {
    std::error_code error;
    std::vector<fs::path> folders{fs::current_path(error)};
    if (const char *home = std::getenv("HOME")) {
        folders.push_back(fs::path(home) / "Pictures");
        folders.emplace_back(home);
    }
    for (const fs::path &folder : folders) {
        if (fs::is_directory(folder, error) && access(folder.c_str(), W_OK) == 0) {
            return folder;
        }
    }
    throw InputError("neither the current folder nor ~/Pictures can be written");
}

} // namespace sandbox
