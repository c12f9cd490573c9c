#include "ui/desktop.h"

#include "image/error.h"

#include <cstdlib>
#include <spawn.h>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace sandbox {

bool is_installed(const std::string &program) {
    const char *path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) {
            return true;
        }
    }
    return false;
}

void open_on_desktop(const std::filesystem::path &path) {
    if (!is_installed("xdg-open")) {
        throw InputError("xdg-open is not installed; the folder is {}", path.string());
    }
    // A shell in between, so that nobody waits for what it starts.
    std::string words[] = {"sh", "-c", "xdg-open \"$0\" >/dev/null 2>&1 &", path.string()};
    char *arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    pid_t shell = 0;
    if (posix_spawnp(&shell, "sh", nullptr, nullptr, arguments, environ) != 0) {
        throw InputError("cannot open {}", path.string());
    }
    waitpid(shell, nullptr, 0);
}

} // namespace sandbox
