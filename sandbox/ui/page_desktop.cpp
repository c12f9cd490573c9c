#include "ui/desktop.h"

namespace sandbox {

bool is_installed(const std::string &) { return false; }

/// What has been written is a download, or stands in the page's editor.
void open_on_desktop(const std::filesystem::path &) {}

} // namespace sandbox
