#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sandbox {

struct JsonReader {
    std::string name;
    std::function<void(const std::string &)> read; ///< throws InputError
};

/// Every reader of JSON that people may hand in.
std::vector<JsonReader> json_readers();

} // namespace sandbox
