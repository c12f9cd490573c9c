#pragma once

#include "measure/diagnosis/diagnosis.h"

#include <string>

namespace sandbox {

/// In sentences, a line each.
std::string diagnosis_text(const Diagnosis &diagnosis, const Scene &scene);

/// Keys: verdict, technique (null if unknown), nearest (of an unknown picture), ties, conventions, residual (levels of
/// 8 bits, the largest; null if a pixel is not finite), residual_rms, residual_pixels (that differ by more than a
/// level), compared_pixels, compared_share, masked, pixel, proposal (null without one), size, and `scene` and
/// `renderer` as given.
std::string diagnosis_json(const Diagnosis &diagnosis, const std::string &scene, const std::string &renderer);

} // namespace sandbox
