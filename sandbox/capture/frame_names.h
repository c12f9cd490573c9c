#pragma once

#include <string>
#include <string_view>

/// Sequences: an angle and a file for each frame.
namespace sandbox {

/// Frame `i` of `frames` of a turn of `degrees` in all: degrees * i / frames, so that a turn of 360 loops.
double orbit_degrees(double degrees, int i, int frames);

/// True if `pattern` holds a conversion (%d, %04d); "%%" is a percent sign.
bool is_frame_pattern(std::string_view pattern);
/// The name of frame `i`. Throws InputError unless `pattern` holds exactly one %d or %0Nd (N from 1 to 9) and no other
/// %.
std::string frame_name(std::string_view pattern, int i);

} // namespace sandbox
