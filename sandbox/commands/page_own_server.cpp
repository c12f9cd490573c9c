#include "commands/commands.h"

namespace sandbox {

void add_own_server_options(CLI::App &, CommonOptions &, Run &) {} // a page starts no process

} // namespace sandbox
