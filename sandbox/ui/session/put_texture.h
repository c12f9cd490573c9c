#pragma once

#include "scene/resources.h"

#include <filesystem>

namespace sandbox {

struct Session;

/// Puts a picture on the object that the Material panel shows, as one edit that can be undone. Throws InputError where
/// the picture cannot be read or there is no object, and then nothing changes.
void put_texture(Session &session, const std::filesystem::path &image, Resources &resources);

} // namespace sandbox
