#include "ui/panels/panels.h"
#include "ui/panels/technique_table.h"

namespace sandbox {

void faults_panel(Session &session) {
    if (!begin_technique_table("faults")) {
        return;
    }
    for (const TechniqueKey &key : technique_keys()) {
        for (int value = 1; key.fault && value < static_cast<int>(key.values.size()); ++value) {
            technique_row(session, key, value, true);
        }
    }
    end_technique_table();
}

} // namespace sandbox
