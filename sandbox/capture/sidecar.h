#pragma once

#include "capture/picture.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// The sidecar: the JSON file beside a picture that reproduces it. It holds the whole scene and every option.
namespace sandbox {

/// What drew a picture: GL_RENDERER and GL_VERSION.
struct DrawnBy {
    std::string renderer;
    std::string opengl;
};

/// a.png -> a.png.json
std::filesystem::path sidecar_path(const std::filesystem::path &picture);

/// Keys: version, renderer, opengl, layout, techniques (one or two: technique_json()), textbook_left masks and the
/// words of overlays (if so), mesh_factors (if any is not 1), flip (A or B: which of two is shown), size, display,
/// exposure, gain, labels, language (unless English), difference_of (of a difference), divider (of a wipe), pixel,
/// vectors, loupe, profile, ring (the marks), view, scene.
/// Paths are relative to `folder`, where it will stand, if they can be (empty: absolute).
std::string sidecar_text(const Scene &scene, const PictureOptions &options, const DrawnBy &by,
                         const std::filesystem::path &folder = {});

/// A sidecar with more keys, a JSON object, before its scene.
std::string with_keys(std::string_view sidecar, std::string_view more);

/// The options of a sidecar in `folder`; nothing if `text` is none (a scene file, an OBJ). `name` is used in messages.
/// Throws InputError if a value is wrong.
std::optional<PictureOptions> sidecar_options(std::string_view text, std::string_view name,
                                              const std::filesystem::path &folder = {});

} // namespace sandbox
