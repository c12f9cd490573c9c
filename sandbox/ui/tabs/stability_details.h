#pragma once

#include "render/target.h"
#include "ui/jobs/stability_list.h"
#include "ui/session/session.h"

#include <array>
#include <optional>

namespace sandbox {

/// Beside the list of cases: the story of the chosen one, its figures, and its pictures textbook | robust | reference.
class StabilityDetails {
  public:
    /// In the current ImGui window.
    void draw(const Session &session, const ListedCase &listed);
    /// The pictures are made anew: another case was chosen, or this one was run again.
    void forget() { pictures_ = {}; }

  private:
    void pictures(const Words &words, const ListedCase &listed);

    std::array<std::optional<DisplayTexture>, 3> pictures_;
};

} // namespace sandbox
