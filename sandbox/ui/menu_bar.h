#pragma once

#include "ui/session/session.h"

namespace sandbox {

void menu_bar(Session &session);

} // namespace sandbox
