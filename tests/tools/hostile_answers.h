#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sandbox {

/// Files that are handed in to do harm: texts that never end, that are enormous, that reach for other stages, that are
/// no text at all; and names, links and devices. All go into `folder`; a link leads to `outside`, which must stay as it
/// is. Returns their names.
std::vector<std::string> write_hostile_answers(const std::filesystem::path &folder,
                                               const std::filesystem::path &outside);

} // namespace sandbox
