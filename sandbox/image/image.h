#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace sandbox {

struct Size {
    int width = 0;
    int height = 0;
    bool operator==(const Size &) const = default;
};
/// Width / height.
constexpr double aspect_of(Size size) { return static_cast<double>(size.width) / static_cast<double>(size.height); }

/// Linear RGBA, float32, row 0 at the top.
struct Image {
    Size size;
    std::vector<glm::vec4> pixels;

    Image() = default;
    explicit Image(Size s, glm::vec4 fill = glm::vec4(0, 0, 0, 1))
        : size(s), pixels(static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height), fill) {}
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] const glm::vec4 &at(int x, int y) const { return pixels[index(x, y)]; }
    [[nodiscard]] glm::vec4 &at(int x, int y) { return pixels[index(x, y)]; }
};

/// The most pixels a side of a picture that is read from a file.
constexpr int max_image_side = 8192;

/// An image from interleaved 8-bit values, 3 or 4 channels a pixel, row 0 at the top; each is divided by 255.
Image from_bytes(Size size, const unsigned char *bytes, int channels);

/// The light that sRGB numbers in [0, 1] encode (IEC 61966-2-1); alpha stays.
Image decoded_srgb(Image image);

/// 8-bit RGB, row 0 at the top: what a PNG holds.
struct ByteImage {
    Size size;
    std::vector<std::uint8_t> rgb;
};

enum class Display { linear, srgb };
/// How a screen shows linear light.
struct DisplayMap {
    Display curve = Display::linear;
    double exposure = 1; ///< multiplies before the curve
    bool operator==(const DisplayMap &) const = default;
};

/// What a screen shows: exposure, clamp to [0, 1], transfer curve, round to nearest. Non-finite pixels become magenta.
ByteImage to_display(const Image &image, Display display = Display::linear, double exposure = 1);

/// A drawn picture: by OpenGL or by the reference.
struct Frame {
    Image color;
    std::vector<std::uint32_t> object_ids; ///< per pixel, 0 background, i + 1 objects[i]; empty unless asked for
    double milliseconds = 0;
};

} // namespace sandbox
