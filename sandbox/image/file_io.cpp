#include "image/file_io.h"

#include "image/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <unistd.h>

namespace sandbox {
namespace {

namespace fs = std::filesystem;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

// This program reads nothing larger; a device or a pipe may never end.
constexpr std::size_t read_limit = std::size_t{1} << 30;

[[noreturn]] void refuse(const fs::path &path, std::string_view what, int error) {
    throw InputError("{}: {} ({})", path.string(), what, std::strerror(error));
}

bool write_whole(const fs::path &path, std::string_view bytes) {
    File file(std::fopen(path.c_str(), "wb"), std::fclose);
    if (!file) {
        return false;
    }
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    return std::fclose(file.release()) == 0 && written;
}

/// Devices and pipes are written in place: renaming a file over /dev/stdout would replace it.
bool written_in_place(const fs::path &path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

} // namespace

std::string read_file(const fs::path &path) {
    const File file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        refuse(path, "cannot read the file", errno);
    }
    std::string bytes;
    char block[65536];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
        bytes.append(block, count);
        if (bytes.size() > read_limit) {
            refuse(path, "the file is too large", EFBIG);
        }
    }
    if (std::ferror(file.get()) != 0) {
        refuse(path, "cannot read the file", errno);
    }
    return bytes;
}

void write_file(const fs::path &path, std::string_view bytes) {
    std::error_code ignored;
    const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
    if (written_in_place(target)) {
        if (!write_whole(target, bytes)) {
            refuse(path, "cannot write the file", errno);
        }
        return;
    }
    fs::path temporary = target;
    temporary += fmt::format(".{}.part", ::getpid());
    if (!write_whole(temporary, bytes) || std::rename(temporary.c_str(), target.c_str()) != 0) {
        const int error = errno;
        fs::remove(temporary, ignored);
        refuse(path, "cannot write the file", error);
    }
}

} // namespace sandbox
