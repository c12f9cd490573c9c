#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// Which object Material and Mesh show; false if the scene has none. No control where there is one alone.
bool object_choice(Session &session);

} // namespace sandbox
