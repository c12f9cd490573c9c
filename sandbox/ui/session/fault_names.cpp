#include "ui/session/fault_names.h"

#include <fmt/format.h>

namespace sandbox {

std::string fault_name(const Words &words, const TechniqueKey &key, int value) {
    const std::string name = fmt::format("fault.{}.{}", key.name, key.values[static_cast<std::size_t>(value)].name);
    return words.english().find(name) != nullptr ? words.text(name) : std::string();
}

} // namespace sandbox
