#include "image/thread.h"

#ifdef __EMSCRIPTEN__
#include "image/page_thread.h"
#else
#include <chrono>
#endif

namespace sandbox {

#ifdef __EMSCRIPTEN__

void let_others_run() { suspend_if_due(); }
void rest() { suspend(); }

#else

void let_others_run() {}
void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

#endif

} // namespace sandbox
