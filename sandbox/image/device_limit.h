#pragma once

#include "image/error.h"

namespace sandbox {

/// The machine can draw, but not this: it is too large for one of its limits. The message names the limit, and what to
/// try.
struct DeviceLimitError : MachineError {
    using MachineError::MachineError;
};

} // namespace sandbox
