#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>

/// Turntables: a camera a frame, a file a frame.
namespace sandbox {

/// `camera` turned by `degrees` about the axis through its target along its up vector, counter-clockwise seen from
/// above. 0 gives the camera itself, to the last bit.
Camera orbit_camera(const Camera &camera, double degrees);

/// Frame `i` of `frames` of a turn of `degrees` in all: degrees * i / frames, so that a turn of 360 loops.
double orbit_degrees(double degrees, int i, int frames);

/// True if `pattern` holds a conversion (%d, %04d); "%%" is a percent sign.
bool is_frame_pattern(std::string_view pattern);
/// The name of frame `i`. Throws InputError unless `pattern` holds exactly one %d or %0Nd (N from 1 to 9) and no other
/// %.
std::string frame_name(std::string_view pattern, int i);

} // namespace sandbox
