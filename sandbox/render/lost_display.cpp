#include "render/lost_display.h"

#include "image/write_guard.h"

#include <cstdio>
#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

namespace sandbox {
namespace {

struct XDisplay; // as far as Xlib's headers, which GLFW alone needs, are missing here
using IoErrorHandler = int (*)(XDisplay *);

constexpr int machine_exit = 3; // what MachineError leads to, which cannot be thrown through Xlib

int end_with_a_sentence(XDisplay * /*lost*/) {
    fmt::print(stderr, "shading-sandbox: the display is lost: the X server ended, or closed the connection\n");
    end_between_writes(machine_exit);
    while (true) { // till another thread has written its file
        pause();
    }
}

} // namespace

void end_when_display_is_lost() {
    using SetHandler = IoErrorHandler (*)(IoErrorHandler);
    void *const xlib = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD); // GLFW has loaded it, if this is X
    if (xlib != nullptr) {
        reinterpret_cast<SetHandler>(dlsym(xlib, "XSetIOErrorHandler"))(end_with_a_sentence);
    }
}

} // namespace sandbox
