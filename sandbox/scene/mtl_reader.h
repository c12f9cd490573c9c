#pragma once

#include "scene/obj_text.h"
#include "scene/scene.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {

/// The materials of a Wavefront MTL text by their names: Ka, Kd, Ks, Ke, Ns, map_Kd; what one does not say is as in
/// `base`. map_Kd gives the texture's path as it stands there, which then colours no highlight. Numbers are within the
/// ranges of a scene's, else they are refused. `name` is used in messages: `a.mtl:3: Kd: expected ...`. `notes` gets
/// what was left out, in one sentence. Throws InputError.
std::map<std::string, Material, std::less<>> read_mtl(TextSource source, std::string_view name, const Material &base,
                                                      std::vector<std::string> &notes);

} // namespace sandbox
