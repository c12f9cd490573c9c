#include "render/own_server.h"
#include "commands/commands.h"
#include "commands/session.h"

namespace sandbox {
namespace {

struct OwnServerFlags {};

int run_own_server(const OwnServerFlags & /*none*/, const CommonOptions &common) {
    std::unique_ptr<DrawingSession> session;
    serve_own_pictures([&]() -> Renderer & {
        session = std::make_unique<DrawingSession>(common, DrawingSession::Own::drawn_here);
        return session->renderer();
    });
    return 0;
}

} // namespace

/// Other commands start it (see OwnProcess).
void add_own_server_options(CLI::App &command, CommonOptions &common, Run &run) {
    run_when_chosen(command, common, run, std::make_shared<OwnServerFlags>(), run_own_server);
}

} // namespace sandbox
