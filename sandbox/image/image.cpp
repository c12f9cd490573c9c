#include "image/image.h"

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

/// The transfer curve of IEC 61966-2-1.
double srgb_curve(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double inverse_srgb_curve(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t to_byte(double value, Display display) {
    const double clamped = std::clamp(value, 0.0, 1.0);
    const double curved = display == Display::srgb ? srgb_curve(clamped) : clamped;
    return static_cast<std::uint8_t>(std::lround(curved * 255));
}

bool finite(const glm::vec4 &pixel) {
    return std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b);
}

} // namespace

Image from_bytes(Size size, const unsigned char *bytes, int channels) {
    Image image(size);
    for (glm::vec4 &pixel : image.pixels) {
        for (int channel = 0; channel < channels; ++channel) {
            pixel[channel] = static_cast<float>(*bytes++) / 255.0F;
        }
    }
    return image;
}

Image decoded_srgb(Image image) {
    for (glm::vec4 &pixel : image.pixels) {
        for (int channel = 0; channel < 3; ++channel) {
            pixel[channel] = static_cast<float>(inverse_srgb_curve(static_cast<double>(pixel[channel])));
        }
    }
    return image;
}

ByteImage to_display(const Image &image, Display display, double exposure) {
    ByteImage out{image.size, {}};
    out.rgb.reserve(image.pixels.size() * 3);
    for (const glm::vec4 &pixel : image.pixels) {
        if (!finite(pixel)) {
            out.rgb.insert(out.rgb.end(), {255, 0, 255});
            continue;
        }
        for (int channel = 0; channel < 3; ++channel) {
            out.rgb.push_back(to_byte(static_cast<double>(pixel[channel]) * exposure, display));
        }
    }
    return out;
}

} // namespace sandbox
