#pragma once

#include <stdexcept>

namespace sandbox {

/// The user's input is wrong (a file, a flag, a value). The message names the file, the key and what was
/// expected, e.g. `three.json: lights[2].attenuation.linear: expected a number >= 0, got -1`. Exit code 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The machine lacks something the work needs (no OpenGL 3.3, say). The message says what was found and
/// what to install. Exit code 3.
struct MachineError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace sandbox
