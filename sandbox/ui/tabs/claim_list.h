#pragma once

#include "teach/claims.h"
#include "ui/session/session.h"

#include <span>

namespace sandbox {

/// A step's claims, each with its bound and, of the first ones, what was measured: a tick, a cross, or a dot where
/// nothing is judged.
void claim_list(Session &session, std::span<const LessonClaim> claims, std::span<const ClaimResult> measured);

} // namespace sandbox
