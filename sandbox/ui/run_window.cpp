#include "ui/run_window.h"

#include "image/error.h"
#include "ui/glfw_window.h"

#include <GLFW/glfw3.h>
#include <cmath>
#include <cstdlib>

namespace sandbox {

namespace {

bool has_display_server() {
    const auto set = [](const char *name) {
        const char *value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

/// No event, no frame.
void wait_for_events(const Window &window) {
    const double longest = window.seconds_left();
    if (longest <= 0) {
        glfwPollEvents();
    } else if (std::isfinite(longest)) {
        glfwWaitEventsTimeout(longest);
    } else {
        glfwWaitEvents();
    }
}

} // namespace

int run_window(const WindowOptions &options) {
    if (!has_display_server()) {
        throw MachineError("no display server (DISPLAY and WAYLAND_DISPLAY are unset), so no window can open. Use "
                           "`shading-sandbox capture SCENE --out FILE.png` for pictures without a window, or run.sh");
    }
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
