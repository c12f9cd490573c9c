#pragma once

#include "image/image.h"
#include "render/gl_object.h"

#include <cstdint>
#include <vector>

namespace sandbox {

/// A framebuffer of linear RGBA32F with a 32-bit float depth, and object ids (R32UI) only while something reads them.
class Target {
  public:
    /// Throws MachineError where the driver refuses (too large, no float targets).
    explicit Target(Size size, bool object_ids = false);

    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] bool has_object_ids() const { return ids_.id() != 0; }
    [[nodiscard]] unsigned framebuffer() const { return framebuffer_.id(); }
    /// The RGBA32F texture: bottom row first, as OpenGL has it.
    [[nodiscard]] unsigned texture() const { return color_.id(); }

    /// Replaces the colours, depth stays: for a picture that the processor drew. `image` has the target's size.
    void write_color(const Image &image);
    /// Reads back, top row first.
    [[nodiscard]] Image read_color() const;
    /// Reads row y, from the top.
    [[nodiscard]] Image read_row(int y) const;
    /// Reads one pixel's linear colour (x right, y down).
    [[nodiscard]] glm::vec4 read_pixel(int x, int y) const;
    [[nodiscard]] std::vector<std::uint32_t> read_object_ids() const;
    /// Waits until all that was drawn into it is done; in turns: see finish_drawing_in_turns().
    void finish() const;
    void finish_in_turns() const;

  private:
    template <typename Pixel>
    [[nodiscard]] std::vector<Pixel> read_pixels(unsigned attachment, unsigned layout, unsigned type) const;

    Size size_;
    Texture color_, ids_;
    Renderbuffer depth_;
    Framebuffer framebuffer_;
};

/// An RGBA8 texture that a window shows: the display transform of a Target, a comparison of two, a finished picture.
class DisplayTexture {
  public:
    explicit DisplayTexture(Size size);
    explicit DisplayTexture(const ByteImage &picture);
    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] unsigned texture() const { return color_.id(); }
    [[nodiscard]] unsigned framebuffer() const { return framebuffer_.id(); }
    void finish() const;
    void finish_in_turns() const;

  private:
    Size size_;
    Texture color_;
    Framebuffer framebuffer_;
};

/// What a screen shows, drawn into directly: RGBA8 with a 24-bit depth.
class ScreenTarget {
  public:
    /// Throws MachineError as Target does.
    explicit ScreenTarget(Size size);
    [[nodiscard]] Size size() const { return color_.size(); }
    [[nodiscard]] unsigned texture() const { return color_.texture(); }
    [[nodiscard]] unsigned framebuffer() const { return color_.framebuffer(); }
    void finish() const { color_.finish(); }
    void finish_in_turns() const { color_.finish_in_turns(); }

  private:
    DisplayTexture color_;
    Renderbuffer depth_;
};

} // namespace sandbox
