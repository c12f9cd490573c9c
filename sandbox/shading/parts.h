#pragma once

#include "scene/assets.h"

#include <map>
#include <string>
#include <string_view>

namespace sandbox {

/// The texts of shaders/, read once, by file name ("light_point.glsl").
class ShaderParts {
  public:
    /// Throws InputError if there is none.
    explicit ShaderParts(Assets shaders);

    /// Throws InputError naming a part that is missing.
    [[nodiscard]] const std::string &text(std::string_view part) const;
    /// True if a file below --shaders DIR changed since it was read; the texts are then the new ones.
    bool reload_changed();

  private:
    Assets assets_;
    std::map<std::string, std::string, std::less<>> texts_;
};

} // namespace sandbox
