#pragma once

#include <string>

namespace sandbox {

/// What stands below the options in --help: techniques (from their own table), exit codes.
std::string help_footer();

} // namespace sandbox
