#include "render/own_process.h"

#include "image/error.h"
#include "render/child_process.h"
#include "render/own_messages.h"
#include "scene/scene_file.h"
#include "shading/own_text.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <utility>

namespace sandbox {

std::vector<std::string> own_server_command(const Assets &assets, const Assets &shaders, Profile profile,
                                            std::string_view backend) {
    std::vector<std::string> command{"/proc/self/exe",     "own-server", "--backend",
                                     std::string(backend), "--profile",  profile == Profile::es ? "es" : "core"};
    for (const auto &[flag, files] : {std::pair("--assets", &assets), std::pair("--shaders", &shaders)}) {
        if (!files->folder().empty()) {
            command.insert(command.end(), {flag, files->folder().string()});
        }
    }
    return command;
}

OwnProcess::OwnProcess(std::vector<std::string> command, OwnLimits limits)
    : command_(std::move(command)), limits_(limits) {}
OwnProcess::~OwnProcess() = default;

/// Whole seconds for the next picture: what the kernel counts in.
int OwnProcess::allowed() const {
    const double left = limits_.seconds_all ? *limits_.seconds_all - used_before_ - used_now_ : limits_.seconds_each;
    return std::min(static_cast<int>(left), limits_.seconds_each);
}

/// What it was asked for last is why it ended.
std::string OwnProcess::why_ended(int allowed) {
    constexpr double patience = 1; // it may have closed its socket a moment before it ends
    const ChildProcess::End end = process_->end(patience);
    process_.reset();
    used_before_ += end.processor_seconds;
    used_now_ = 0;
    if (end.signal == SIGXCPU || end.signal == SIGKILL) {
        return fmt::format("{}: took more than {} s of processor time to compile and draw", text_->file, allowed);
    }
    return fmt::format("{}: the process that compiled and drew it {}", text_->file,
                       end.signal != 0 ? fmt::format("was ended by signal {} ({})", end.signal, strsignal(end.signal))
                                       : "ended without a picture");
}

Frame OwnProcess::picture(const Scene &scene, const Technique &technique, Size size, bool object_ids) {
    if (technique.own != text_) {
        process_.reset();
        text_ = technique.own;
        used_before_ = used_now_ = 0;
    }
    if (failure_ && failure_->scene == scene && failure_->technique == technique) {
        throw InputError(failure_->why);
    }
    const int seconds = allowed();
    if (seconds < 1) {
        throw InputError("{}: took more than {} s of processor time for all its pictures", text_->file,
                         *limits_.seconds_all);
    }
    if (process_ == nullptr) {
        process_ = std::make_unique<ChildProcess>(command_);
    }
    // By the clock there is time for a machine that does much else; a driver that sleeps for good ends here.
    const double deadline = monotonic_seconds() + 30 + 10.0 * seconds;
    const OwnRequest request{scene_text(scene),
                             to_string(technique),
                             text_->file,
                             text_->text,
                             scene.camera.picture_shift,
                             size,
                             object_ids,
                             seconds};
    // What cannot be sent may have been answered: a process that has no OpenGL says so and ends.
    static_cast<void>(send_request(process_->socket(), request, deadline));
    std::optional<OwnResponse> response = receive_response(process_->socket(), size, object_ids, deadline);
    if (!response) {
        failure_ = {scene, technique, why_ended(seconds)};
        throw InputError(failure_->why);
    }
    used_now_ = response->processor_seconds;
    switch (response->outcome) {
    case OwnResponse::Outcome::picture:
        return std::move(response->frame);
    case OwnResponse::Outcome::machine_error:
        throw MachineError(response->message);
    case OwnResponse::Outcome::input_error:
        break;
    }
    throw InputError(response->message);
}

std::function<Frame(const Scene &, const Technique &, Size, bool)> drawn_by(OwnProcess &own) {
    return [&own](const Scene &scene, const Technique &technique, Size size, bool object_ids) {
        return own.picture(scene, technique, size, object_ids);
    };
}

} // namespace sandbox
