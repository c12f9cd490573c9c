#include "render/own_server.h"

#include "image/error.h"
#include "render/gl_program.h"
#include "render/own_messages.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <new>
#include <string>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sandbox {
namespace {

constexpr rlim_t own_memory = rlim_t{1} << 30;    ///< bytes, beyond what the renderer took before it saw any own text
constexpr rlim_t largest_file = rlim_t{16} << 20; ///< bytes; drivers keep compiled programs in files

void limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min(value, limits.rlim_max);
    setrlimit(resource, &limits);
}

double processor_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval &t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Private memory that can be written to, in bytes: what RLIMIT_DATA counts. 0 where it cannot be found out.
rlim_t data_bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (constexpr std::string_view key = "VmData:"; line.starts_with(key)) {
            return static_cast<rlim_t>(std::stoull(line.substr(key.size()))) * 1024;
        }
    }
    return 0;
}

void limit_to_our_own_needs() {
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, largest_file);
    std::signal(SIGXFSZ, SIG_IGN); // a driver's cache that cannot grow is no reason to end
    if (const rlim_t now = data_bytes(); now > 0) {
        limit(RLIMIT_DATA, now + own_memory);
    }
}

OwnResponse failure(OwnResponse::Outcome outcome, const std::string &message) { return {outcome, {}, message, 0}; }

OwnResponse answer(Renderer &renderer, const OwnRequest &request) {
    try {
        Scene scene = parse_scene(request.scene, "the scene", "/");
        scene.camera.picture_shift = request.picture_shift;
        const Technique technique = parse_technique_with(OwnShader(request.file, request.text), request.technique);
        return {
            OwnResponse::Outcome::picture, renderer.render(scene, technique, request.size, request.object_ids), {}, 0};
    } catch (const InputError &error) {
        return failure(OwnResponse::Outcome::input_error, error.what());
    } catch (const ShaderError &error) { // the text and the scene together, as too many uniforms
        return failure(OwnResponse::Outcome::input_error, request.file + ": " + error.what());
    } catch (const std::bad_alloc &) {
        return failure(OwnResponse::Outcome::input_error, request.file + ": takes more memory than there is for it");
    } catch (const std::exception &error) {
        return failure(OwnResponse::Outcome::machine_error, error.what());
    }
}

} // namespace

void serve_own_pictures(const std::function<Renderer &()> &make) {
    struct stat input {};
    if (fstat(STDIN_FILENO, &input) != 0 || !S_ISSOCK(input.st_mode)) {
        throw InputError("own-server: standard input is no socket: it is started by other commands, not by hand");
    }
    const Socket socket(dup(STDIN_FILENO));
    Renderer *renderer = nullptr;
    while (const auto request = receive_request(socket, no_deadline)) {
        OwnResponse response;
        try {
            if (renderer == nullptr) {
                renderer = &make();
                limit_to_our_own_needs();
            }
            limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(processor_seconds())) +
                                  static_cast<rlim_t>(request->processor_seconds));
            response = answer(*renderer, *request);
        } catch (const MachineError &error) {
            response = failure(OwnResponse::Outcome::machine_error, error.what());
        }
        response.processor_seconds = processor_seconds();
        if (!send_response(socket, response, no_deadline)) {
            return;
        }
    }
}

} // namespace sandbox
