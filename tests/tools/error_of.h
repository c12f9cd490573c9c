#pragma once

#include "image/error.h"

#include <string>

namespace sandbox {

/// The message of the InputError that `action` throws; "no error" if it throws none.
template <class Action> std::string error_of(Action action) {
    try {
        action();
    } catch (const InputError &error) {
        return error.what();
    }
    return "no error";
}

} // namespace sandbox
