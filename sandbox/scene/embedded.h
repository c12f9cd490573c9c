#pragma once

#include <span>
#include <string_view>

namespace sandbox {

/// A file of assets/ or shaders/ that the build put inside the executable.
struct EmbeddedFile {
    std::string_view path; ///< e.g. "shaders/light_point.glsl"
    std::string_view bytes;
};

/// All of them, sorted by path (the definition is generated at build time).
std::span<const EmbeddedFile> embedded_files();

} // namespace sandbox
