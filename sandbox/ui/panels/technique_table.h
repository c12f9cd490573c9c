#pragma once

#include "ui/session/session.h"

namespace sandbox {

/// A table whose rows are values of technique keys and whose columns are A and B: one click sets one side.
bool begin_technique_table(const char *id);
void end_technique_table();

/// One row: `value` of `key`. Round marks choose among frequencies and models; square ones switch a setting on and off
/// (off is the key's default). No row where both sides refuse the value; "no effect here" where no side's picture of
/// this scene can show it; no mark on a side that cannot use it.
void technique_row(Session &session, const TechniqueKey &key, int value);

/// A row for each value but the default of all settings of this kind.
void setting_rows(Session &session, TechniqueKey::Kind kind);

} // namespace sandbox
