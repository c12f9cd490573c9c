#pragma once

namespace sandbox {

/// The transfer curve of sRGB (IEC 61966-2-1), from linear light in [0, 1] to the number that encodes it, and back.
double srgb_curve(double linear);
double inverse_srgb_curve(double encoded);

} // namespace sandbox
