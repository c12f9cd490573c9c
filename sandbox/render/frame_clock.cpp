#include "render/frame_clock.h"

#include "render/gl.h"
#include "render/gl_state.h"

#include <chrono>

namespace sandbox {

namespace {

constexpr double long_draw = 50; // ms

double wall_milliseconds(const Target &target, const std::function<void()> &frame) {
    const auto start = std::chrono::steady_clock::now();
    frame();
    target.finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double gpu_milliseconds(const Query &timer, const std::function<void()> &frame) {
    glBeginQuery(GL_TIME_ELAPSED, timer.id());
    frame();
    glEndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(timer.id(), GL_QUERY_RESULT, &nanoseconds); // waits
    return static_cast<double>(nanoseconds) * 1e-6;
}

/// Both clocks around the same frames, many enough that starting and waiting do not matter.
bool agrees_on_long_draw(const Query &timer, const Target &target, const std::function<void()> &frame) {
    wall_milliseconds(target, frame); // the program is built
    int frames = 1;
    for (;;) {
        double gpu = 0;
        const double wall = wall_milliseconds(target, [&] {
            gpu = gpu_milliseconds(timer, [&] {
                for (int i = 0; i < frames; ++i) {
                    frame();
                }
            });
        });
        if (wall >= long_draw) {
            return clocks_agree(gpu, wall);
        }
        frames *= 2;
    }
}

} // namespace

bool clocks_agree(double gpu_milliseconds, double wall_milliseconds) {
    return gpu_milliseconds >= 0.8 * wall_milliseconds && gpu_milliseconds <= 1.05 * wall_milliseconds;
}

FrameClock::FrameClock(bool software, const Target &target, const std::function<void()> &frame) : target_(target) {
    if (software || is_es()) { // ES has no timer
        return;
    }
    Query timer = make_query();
    if (agrees_on_long_draw(timer, target, frame)) {
        timer_ = std::move(timer);
    }
}

double FrameClock::milliseconds(const std::function<void()> &frame) {
    return timer_ ? gpu_milliseconds(*timer_, frame) : wall_milliseconds(target_, frame);
}

std::string_view FrameClock::name() const { return timer_ ? gpu_clock : wall_clock; }

} // namespace sandbox
