#pragma once

#include "render/uniforms.h"
#include "render/uploader.h"

namespace sandbox {

/// The uniforms by which a full program branches, and its lights.
void put_full_uniforms(Uploader &uploader, const DrawInput &input, double scale);

} // namespace sandbox
