#pragma once

#include "scene/motion.h"

#include <optional>
#include <string>
#include <string_view>

/// Sequences, turntables and motions: the file name of each frame, and their one sidecar.
namespace sandbox {

/// The turn at frame `i` of `frames`, where `degrees` is the whole turn: degrees * i / frames, so that 360 loops.
double orbit_degrees(double degrees, int i, int frames);

/// Whether `pattern` holds a frame number (%d, %04d); "%%" is a percent sign.
bool is_frame_pattern(std::string_view pattern);
/// The name of frame `i`. Throws InputError unless `pattern` holds exactly one %d or %0Nd (N from 1 to 9) and no other
/// %.
std::string frame_name(std::string_view pattern, int i);

struct Turntable {
    int frames = 1;
    double degrees = 0; ///< the whole turn, in the range `rotation`
    bool operator==(const Turntable &) const = default;
};
/// The sidecar of a turntable: its first frame's (sidecar_text()) with the keys frames and orbit_degrees.
std::string turntable_text(std::string_view first_frame, const Turntable &turntable);
/// The turntable of a sidecar; nothing if `text` is of one picture, or no sidecar. Throws InputError if one of the two
/// keys is wrong or lacks the other.
std::optional<Turntable> turntable_of(std::string_view text, std::string_view name);
/// The sidecar of a motion's round: its scene's (sidecar_text()) with the key motion.
std::string motion_sidecar(std::string_view sidecar, const Motion &motion);
/// The motion of a sidecar; nothing if `text` has none. Throws InputError if it is wrong.
std::optional<Motion> motion_of(std::string_view text, std::string_view name);
/// Throws InputError unless `frames` is from 1 to 100000.
int checked_frames(int frames);

} // namespace sandbox
