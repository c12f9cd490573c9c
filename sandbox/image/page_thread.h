#pragma once

#include <cstddef>
#include <vector>

namespace sandbox {

/// Where a stack that lies there begins: WebAssembly's stacks grow downwards.
void *stack_top(std::vector<std::byte> &stack);

} // namespace sandbox
