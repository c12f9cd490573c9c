#pragma once

namespace sandbox {

/// The IEEE half nearest to x, to even between two: 11 binary digits. Beyond 65504 (from 65520 on) infinite; what half
/// would hold as a subnormal, below 2^-14, is 0, as many devices have it. A NaN stays one.
double to_half(double x);

} // namespace sandbox
