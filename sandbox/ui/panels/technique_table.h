#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// A table whose rows are values of technique keys and whose columns are A and B: one click sets one side.
bool begin_technique_table(const char *id);
void end_technique_table();

/// One row: `value` of `key`. Round marks choose among values; square ones switch a value on and off (off is the key's
/// default). No row where neither side can use it; no mark on a side that cannot.
void technique_row(Session &session, const TechniqueKey &key, int value, bool square);

} // namespace sandbox
