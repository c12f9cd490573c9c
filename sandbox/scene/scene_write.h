#pragma once

#include "scene/scene_json.h"

namespace sandbox {

enum class Keys { needed, all };
/// Scene to JSON. `needed` leaves out the keys that are at their defaults.
OrderedJson write_scene(const Scene &scene, Keys keys);

} // namespace sandbox
