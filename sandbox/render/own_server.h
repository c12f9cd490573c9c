#pragma once

#include "render/renderer.h"

#include <functional>
#include <memory>

namespace sandbox {

/// The other side of OwnProcess: draws what is asked for at standard input, a socket, until it is closed; within limits
/// on processor time, memory and written files. `make` gives the renderer; a MachineError of its is the answer.
/// Throws InputError if standard input is no socket.
void serve_own_pictures(const std::function<Renderer &()> &make);

} // namespace sandbox
