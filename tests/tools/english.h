#pragma once

#include "words/words.h"

namespace sandbox {

/// The texts that tests expect.
inline const Words english = words_in("en");

} // namespace sandbox
