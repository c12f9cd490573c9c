#pragma once

#include <string>
#include <string_view>

/// Turntables: the angle and the file name of each frame.
namespace sandbox {

/// The turn at frame `i` of `frames`, where `degrees` is the whole turn: degrees * i / frames, so that 360 loops.
double orbit_degrees(double degrees, int i, int frames);

/// Whether `pattern` holds a frame number (%d, %04d); "%%" is a percent sign.
bool is_frame_pattern(std::string_view pattern);
/// The name of frame `i`. Throws InputError unless `pattern` holds exactly one %d or %0Nd (N from 1 to 9) and no other
/// %.
std::string frame_name(std::string_view pattern, int i);

} // namespace sandbox
