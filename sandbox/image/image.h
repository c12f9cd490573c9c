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

/// 8-bit RGB, row 0 at the top: what a PNG holds.
struct ByteImage {
    Size size;
    std::vector<std::uint8_t> rgb;
};

enum class Display { linear, srgb };

/// What a screen shows: exposure, clamp to [0, 1], the transfer curve, round to nearest. Non-finite becomes magenta.
ByteImage to_display(const Image &image, Display display = Display::linear, double exposure = 1);

/// A drawn picture, whatever drew it.
struct Frame {
    Image color;
    std::vector<std::uint32_t> object_ids; ///< per pixel, 0 background, i + 1 objects[i]; empty unless asked for
    double milliseconds = 0;
};

} // namespace sandbox
