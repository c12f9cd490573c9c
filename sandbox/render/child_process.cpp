#include "render/child_process.h"

#include "image/error.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sandbox {
namespace {

[[noreturn]] void cannot_start(const std::string &program, int error) {
    throw MachineError("{}: cannot be started to draw own shading: {}", program, std::strerror(error));
}

class FileActions {
  public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions &) = delete;
    FileActions &operator=(const FileActions &) = delete;
    [[nodiscard]] posix_spawn_file_actions_t *get() { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

double seconds(const timeval &time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

ChildProcess::ChildProcess(const std::vector<std::string> &command) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        cannot_start(command.front(), errno);
    }
    socket_ = std::make_unique<Socket>(ends[0]);
    const Socket theirs(ends[1]); // closed here once the process has its own copy
    FileActions files;
    posix_spawn_file_actions_adddup2(files.get(), theirs.descriptor(), STDIN_FILENO);
    for (const int printed : {STDOUT_FILENO, STDERR_FILENO}) {
        posix_spawn_file_actions_addopen(files.get(), printed, "/dev/null", O_WRONLY, 0);
    }
    std::vector<std::string> words = command;
    std::vector<char *> arguments;
    std::ranges::transform(words, std::back_inserter(arguments), [](std::string &word) { return word.data(); });
    arguments.push_back(nullptr);
    if (const int error = posix_spawn(&process_, arguments[0], files.get(), nullptr, arguments.data(), environ)) {
        process_ = 0;
        cannot_start(command.front(), error);
    }
}

bool ChildProcess::has_ended() const {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0;
}

ChildProcess::End ChildProcess::end(double patience) {
    if (process_ == 0) {
        return end_;
    }
    const double until = monotonic_seconds() + patience;
    while (monotonic_seconds() < until && !has_ended()) {
        constexpr useconds_t pause = 2000; // microseconds
        usleep(pause);
    }
    kill(process_, SIGKILL); // no more than a remark to one that has ended: it keeps its number until it is waited for
    int status = 0;
    rusage used{};
    while (wait4(process_, &status, 0, &used) < 0 && errno == EINTR) {
    }
    process_ = 0;
    end_ = {WIFSIGNALED(status) ? WTERMSIG(status) : 0, seconds(used.ru_utime) + seconds(used.ru_stime)};
    return end_;
}

} // namespace sandbox
