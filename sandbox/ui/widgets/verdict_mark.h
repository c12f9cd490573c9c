#pragma once

namespace sandbox {

enum class VerdictMark { none, dot, tick, cross };

/// As wide as a line is high; what comes next stands beside it.
void draw_mark(VerdictMark mark);

} // namespace sandbox
