#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sandbox {

struct ProcessResult {
    int exit_code = -1; ///< -1: ended by a signal
    std::string out, err;
};

/// Runs the program with `arguments` (its own folder as the current one) and waits. `setup` goes before it on the
/// shell's line, e.g. "env -u DISPLAY"; `redirect` after it, e.g. "< lines.txt".
ProcessResult run_sandbox(const std::vector<std::string> &arguments, const std::string &setup = {},
                          const std::string &redirect = {});

/// A folder of its own for a test, removed with it.
class TestFolder {
  public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder &) = delete;
    TestFolder &operator=(const TestFolder &) = delete;
    [[nodiscard]] std::string file(const std::string &name) const { return (path_ / name).string(); }
    void write(const std::string &name, const std::string &text) const;
    [[nodiscard]] std::string read(const std::string &name) const;
    /// Names of all that is in it, sorted.
    [[nodiscard]] std::vector<std::string> names() const;

  private:
    std::filesystem::path path_;
};

} // namespace sandbox
