#pragma once

#include "image/image.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Pictures as numbers that a screen shows, in levels of 8 bits, and how far apart two of them are.
namespace sandbox {

/// How linear light became the numbers of a picture.
enum class Encoding { linear, srgb, gamma };

/// How a picture's numbers are to be understood.
struct Reading {
    Encoding encoding = Encoding::linear;
    bool flipped = false; ///< its first row is the bottom one
    bool clamped = false; ///< of a picture in floats: light above white became white
    bool operator==(const Reading &) const = default;
};

/// A picture of any program.
struct Observed {
    Image numbers;     ///< those of its file; bytes / 255
    bool bytes = true; ///< 8 bits a channel, as displayed; else floats, where light above white is kept
};

/// A PNG or PFM file, told by its first bytes. Throws InputError that begins with `name`.
Observed decode_observed(std::string_view bytes, const std::string &name);

/// Three values a pixel, 255: white. Infinite where the picture is not finite.
using Levels = std::vector<float>;

/// The numbers of the file; its rows turned over where `reading` says so.
Levels observed_levels(const Observed &observed, const Reading &reading);
/// What a program that draws `drawn` would have written to a file of the same kind.
Levels shown_levels(const Image &drawn, const Reading &reading, bool bytes);
/// The number for linear light, 1: white.
double encoded(double linear, Encoding encoding);
/// Undoes the encoding of one number, 1: white.
double decoded(double number, Encoding encoding);

/// By how much two pictures differ at the pixels where `compared` is not 0.
struct Difference {
    double largest = 0;    ///< levels; infinite if a pixel is not finite
    std::size_t pixel = 0; ///< where
    std::size_t over = 0;  ///< pixels that differ by more than a limit
    std::size_t compared = 0;
    double rms = 0; ///< levels, each channel's difference cut at 16: one pixel more or less decides nothing
};
Difference difference_of(const Levels &a, const Levels &b, const std::vector<std::uint8_t> &compared, double limit);

/// What explains a picture and ties may differ by: one level, up to the rounding of the division by 255.
constexpr double tolerated_levels = 1.001;

} // namespace sandbox
