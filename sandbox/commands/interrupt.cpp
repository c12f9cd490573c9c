#include "commands/interrupt.h"

#include "image/write_guard.h"

#include <csignal>

namespace sandbox {

void handle_interrupts() {
    struct sigaction action {};
    action.sa_handler = [](int) { end_between_writes(); };
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace sandbox
