#pragma once

#include <string>

namespace sandbox {

/// The JSON schema of scene files, made from the reader's own table.
std::string scene_schema();

} // namespace sandbox
