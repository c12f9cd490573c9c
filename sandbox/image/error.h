#pragma once

#include <fmt/core.h>
#include <stdexcept>
#include <string>
#include <utility>

namespace sandbox {

/// An error with a formatted message: InputError("{}: expected a number >= 0, got {}", key, value).
class MessageError : public std::runtime_error {
  public:
    explicit MessageError(const std::string &message) : std::runtime_error(message) {}
    template <typename First, typename... More>
    explicit MessageError(fmt::format_string<First, More...> message, First &&first, More &&...more)
        : std::runtime_error(fmt::format(message, std::forward<First>(first), std::forward<More>(more)...)) {}
};

/// The user's input is wrong (a file, a flag, a value). The message names the file, the key and what was
/// expected, e.g. `three.json: lights[2].attenuation.linear: expected a number >= 0, got -1`. Exit code 2.
struct InputError : MessageError {
    using MessageError::MessageError;
};

/// The machine lacks something the work needs (no OpenGL 3.3, say). The message says what was found and
/// what to install. Exit code 3.
struct MachineError : MessageError {
    using MessageError::MessageError;
};

} // namespace sandbox
