#pragma once

#include "capture/layout.h"
#include "scene/scene.h"
#include "shading/technique.h"

#include <optional>
#include <string_view>

namespace sandbox {

/// What the window shows of a scene when it opens; absent: what it shows already.
struct OpeningView {
    std::optional<Technique> left, right;
    std::optional<Layout> layout;
};

/// The scene's key `compare`. Throws InputError: `name: compare.left: ...`.
OpeningView opening_view(const Scene &scene, std::string_view name);

} // namespace sandbox
