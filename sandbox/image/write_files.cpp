#include "image/write_files.h"

#include "image/error.h"
#include "image/write_guard.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

bool write_whole(const fs::path &path, std::string_view bytes) {
    std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "wb"), std::fclose);
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

fs::path behind_links(const fs::path &path) {
    std::error_code failed; // a ring of links: the link itself is replaced
    const fs::path behind = fs::is_symlink(path, failed) ? fs::weakly_canonical(path, failed) : path;
    return behind.empty() ? path : behind;
}

constexpr std::size_t probe_size = std::size_t{1} << 16; // more than a full disk has left

/// A file under a temporary name beside its own. Unless it is kept, all is as before when the object goes.
class StagedFile {
  public:
    /// `number`: of the set, which may name a file twice. A device is written here. Throws InputError.
    StagedFile(const fs::path &path, std::string_view bytes, std::size_t number)
        : path_(path), target_(behind_links(path)) {
        if (written_in_place(target_)) {
            if (!write_whole(target_, bytes)) {
                fail(errno);
            }
            return;
        }
        temporary_ = beside(number, "part");
        old_ = beside(number, "old");
        if (!write_whole(temporary_, bytes)) {
            const int error = errno;
            remove(temporary_);
            fail(error);
        }
    }
    ~StagedFile() {
        remove(temporary_);
        if (has_old_ && !kept_) {
            std::rename(old_.c_str(), target_.c_str());
        } else if (placed_ && !kept_) {
            remove(target_);
        }
        remove(has_old_ ? old_ : fs::path());
    }
    StagedFile(const StagedFile &) = delete;
    StagedFile &operator=(const StagedFile &) = delete;

    /// Gives what stands there a second name, under which it can come back. Throws InputError.
    void save_old() {
        if (temporary_.empty()) {
            return;
        }
        if (fs::is_directory(target_)) { // by now
            fail(EISDIR);
        }
        has_old_ = ::link(target_.c_str(), old_.c_str()) == 0 || // which not every disk has
                   std::rename(target_.c_str(), old_.c_str()) == 0;
        if (!has_old_ && errno != ENOENT) {
            fail(errno);
        }
    }
    /// Throws InputError.
    void put_in_place() {
        if (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0) {
            fail(errno);
        }
        placed_ = !temporary_.empty();
        temporary_.clear();
    }
    void keep() { kept_ = true; }

  private:
    fs::path path_, target_;
    fs::path temporary_; ///< empty: a device, or in place
    fs::path old_;
    bool has_old_ = false, placed_ = false, kept_ = false;

    [[noreturn]] void fail(int error) const {
        throw InputError("{}: cannot write the file ({})", path_.string(), std::strerror(error));
    }
    [[nodiscard]] fs::path beside(std::size_t number, std::string_view ending) const {
        fs::path path = target_;
        path += fmt::format(".{}.{}.{}", ::getpid(), number, ending);
        return path;
    }
    static void remove(const fs::path &path) {
        std::error_code ignored;
        fs::remove(path, ignored);
    }
};

} // namespace

void write_files(std::span<const OutputFile> files) {
    const WriteGuard guard;
    std::deque<StagedFile> staged;
    for (const OutputFile &file : files) {
        staged.emplace_back(file.path, file.bytes, staged.size());
    }
    for (std::size_t i = 0; i + 1 < staged.size(); ++i) { // the last one changes nothing if it fails
        staged[i].save_old();
    }
    std::ranges::for_each(staged, &StagedFile::put_in_place);
    std::ranges::for_each(staged, &StagedFile::keep);
}

void write_file(const fs::path &path, std::string_view bytes) {
    const WriteGuard guard;
    StagedFile file(path, bytes, 0);
    file.put_in_place();
    file.keep();
}

void check_writable(const fs::path &path) {
    const fs::path target = behind_links(path);
    if (written_in_place(target) && !fs::is_directory(target)) {
        return;
    }
    const WriteGuard guard;
    const StagedFile probe(path, std::string(probe_size, '\0'), 0); // goes with the object
}

} // namespace sandbox
