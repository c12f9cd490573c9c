#include "image/file_io.h"

#include "image/error.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace sandbox {
namespace {

namespace fs = std::filesystem;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

[[noreturn]] void refuse(const fs::path &path, std::string_view what, int error) {
    throw InputError("{}: {} ({})", path.string(), what, std::strerror(error));
}

[[noreturn]] void refuse_size(const fs::path &path, std::size_t most) {
    throw InputError("{}: the file is larger than {} MiB", path.string(), most >> 20);
}

std::string_view kind_of(mode_t mode) {
    return S_ISFIFO(mode)                   ? "a pipe"
           : S_ISSOCK(mode)                 ? "a socket"
           : S_ISCHR(mode) || S_ISBLK(mode) ? "a device"
                                            : "another kind of file";
}

} // namespace

std::string read_file(const fs::path &path, std::size_t most) {
    // A pipe that nobody writes to is opened all the same, and refused.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const File file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"), std::fclose);
    struct stat found {};
    if (!file || ::fstat(descriptor, &found) != 0) {
        refuse(path, "cannot read the file", errno);
    }
    if (S_ISDIR(found.st_mode)) {
        refuse(path, "cannot read the file", EISDIR);
    }
    if (!S_ISREG(found.st_mode)) {
        throw InputError("{}: expected a regular file, got {}", path.string(), kind_of(found.st_mode));
    }
    if (static_cast<std::uintmax_t>(found.st_size) > most) {
        refuse_size(path, most);
    }
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(found.st_size));
    char block[65536];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
        bytes.append(block, count);
        if (bytes.size() > most) { // it grew, or has no size, as in /proc
            refuse_size(path, most);
        }
    }
    if (std::ferror(file.get()) != 0) {
        refuse(path, "cannot read the file", errno);
    }
    return bytes;
}

} // namespace sandbox
