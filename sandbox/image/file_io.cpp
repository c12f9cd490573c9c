#include "image/file_io.h"

#include "image/error.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

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

FileReader::FileReader(fs::path path, std::size_t most)
    : path_(std::move(path)), file_(nullptr, std::fclose), most_(most) {
    // A pipe that nobody writes to is opened all the same, and refused.
    const int descriptor = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    file_.reset(descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"));
    struct stat found {};
    if (!file_ || ::fstat(descriptor, &found) != 0) {
        refuse(path_, "cannot read the file", errno);
    }
    if (S_ISDIR(found.st_mode)) {
        refuse(path_, "cannot read the file", EISDIR);
    }
    if (!S_ISREG(found.st_mode)) {
        throw InputError("{}: expected a regular file, got {}", path_.string(), kind_of(found.st_mode));
    }
    if (static_cast<std::uintmax_t>(found.st_size) > most_) {
        refuse_size(path_, most_);
    }
    size_ = static_cast<std::size_t>(found.st_size);
}

std::size_t FileReader::read(std::span<char> bytes) {
    const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file_.get());
    taken_ += count;
    if (taken_ > most_) { // it grew, or has no size, as in /proc
        refuse_size(path_, most_);
    }
    if (std::ferror(file_.get()) != 0) {
        refuse(path_, "cannot read the file", errno);
    }
    return count;
}

std::string read_file(const fs::path &path, std::size_t most) {
    FileReader file(path, most);
    std::string bytes;
    bytes.reserve(file.size());
    std::array<char, 65536> block{};
    while (const std::size_t count = file.read(block)) {
        bytes.append(block.data(), count);
    }
    return bytes;
}

} // namespace sandbox
