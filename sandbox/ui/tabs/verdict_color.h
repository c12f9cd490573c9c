#pragma once

#include "ui/jobs/stability_list.h"

#include <imgui.h>

namespace sandbox {

/// Blue where a bound holds, the error colour where it breaks: apart for all eyes, and the word stands there too.
ImVec4 verdict_color(Verdict verdict);

} // namespace sandbox
