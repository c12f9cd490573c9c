#include "image/page_thread.h"
#include "ui/page_host.h"
#include "ui/run_window.h"

#include <emscripten.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

// sandbox/page/browser.js
extern "C" {
void page_loop(double (*step)(void *), void *window, void *stack);
void page_fail(const char *why);
}

namespace sandbox {
namespace {

constexpr std::size_t window_stack = std::size_t{2} << 20; ///< bytes

/// The window and what it stands on, for as long as the page is open.
struct PageWindow {
    explicit PageWindow(const WindowOptions &options) : window(options, host) {}

    PageHost host;
    Window window;
    std::vector<std::byte> stack = std::vector<std::byte>(window_stack);
    std::string state;

    /// Draws what has to be drawn; returns for how many seconds there is nothing to do unless something arrives.
    double step() {
        try {
            host.context().make_current(); // a job may have drawn
            window.keep_time();
            window.step();
        } catch (const std::exception &error) {
            page_fail(error.what());
            return INFINITY;
        }
        return window.seconds_left();
    }
};

} // namespace

int run_window(const WindowOptions &options) {
    auto *const shown = new PageWindow(options); // the page ends it
    page_loop([](void *window) { return static_cast<PageWindow *>(window)->step(); }, shown, stack_top(shown->stack));
    return 0;
}

} // namespace sandbox

// What sandbox/page/browser.js calls when the page is hidden, which may be its end.
extern "C" EMSCRIPTEN_KEEPALIVE const char *page_keep(void *window) {
    auto *const shown = static_cast<sandbox::PageWindow *>(window);
    try {
        shown->state = shown->window.keep();
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    return shown->state.c_str(); // the last that could
}
