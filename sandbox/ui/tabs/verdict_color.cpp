#include "ui/tabs/verdict_color.h"

#include "ui/widgets/theme.h"

namespace sandbox {

ImVec4 verdict_color(Verdict verdict) {
    switch (verdict) {
    case Verdict::not_run:
        return quiet_text();
    case Verdict::holds:
        return side_color(true);
    case Verdict::breaks:
        return error_text();
    }
    return quiet_text();
}

} // namespace sandbox
