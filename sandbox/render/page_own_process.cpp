#include "render/own_process.h"

#include <utility>

namespace sandbox {

class ChildProcess {}; // a page can start none

std::vector<std::string> own_server_command(const Assets &, const Assets &, Profile, std::string_view) { return {}; }

OwnProcess::OwnProcess(std::vector<std::string> command, OwnLimits limits)
    : command_(std::move(command)), limits_(limits) {}
OwnProcess::~OwnProcess() = default;

std::function<Frame(const Scene &, const Technique &, Size, bool)> drawn_by(OwnProcess &) { return {}; }

} // namespace sandbox
