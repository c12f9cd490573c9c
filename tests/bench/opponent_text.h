#pragma once

#include "opponent.h"

#include <string>

namespace sandbox {

/// What an opponent writes by hand.
struct OpponentText {
    std::string vertex, fragment;
};
OpponentText opponent_text(const Scene &scene, const Opponent::Kind &kind);

} // namespace sandbox
