#pragma once

#include <cstddef>
#include <vector>

namespace sandbox {

/// False: suspend() would return at once, and nothing else would have run (no JSPI).
bool can_suspend();
/// Stops the running thread until the page has had its turn; the second one only if it has run for long.
void suspend();
void suspend_if_due();

/// Where a stack that lies there begins: WebAssembly's stacks grow downwards.
void *stack_top(std::vector<std::byte> &stack);

} // namespace sandbox
