#include "ui/run_window.h"

#include "ui/glfw_window.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace sandbox {

namespace {

constexpr double poll_seconds = 0.5; ///< of files

/// No event, no frame.
void wait_for_events(const Window &window) {
    const double longest = std::min(window.seconds_left(), window.watches_files() ? poll_seconds : INFINITY);
    if (window.unsettled() || longest <= 0) {
        glfwPollEvents();
    } else if (std::isfinite(longest)) {
        glfwWaitEventsTimeout(longest);
    } else {
        glfwWaitEvents();
    }
}

} // namespace

int run_window(const WindowOptions &options) {
    GlfwWindow host(options.size.value_or(options.settings.window), options.profile);
    Window window(options, host);
    window.step();
    host.show();
    while (!host.close_asked() && !window.quit_asked()) {
        wait_for_events(window);
        window.keep_time();
        window.step();
    }
    host.hide(); // work in the background may take a moment to stop
    return 0;
}

} // namespace sandbox
