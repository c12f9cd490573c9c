#include "image/image.h"

#include "image/srgb.h"
#include "image/thread.h"

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

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
    let_others_run();
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
