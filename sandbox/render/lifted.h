#pragma once

#include "image/image.h"
#include "render/gl_program.h"
#include "scene/scene.h"
#include "scene/space.h"
#include "shading/eye_space.h"

namespace sandbox {

/// Pixels. A line's lie up to half a pixel beside it, where a surface seen at up to 86 degrees from its normal is
/// nearer by tan(86 degrees) = 14 times that.
constexpr double lines_lift = 7;
/// Pixels. What covers a surface's own pixels need but be in front of how depth is rounded.
constexpr double stripes_lift = 0.1;

/// Sets where what lies on a surface is drawn: nearer to the eye than it by so many pixels, which keeps it in front.
/// `deep` as in Features.
void put_lifted(const GlProgram &program, const Scene &scene, const EyeSpace &space, Size size, bool deep,
                double pixels);

} // namespace sandbox
