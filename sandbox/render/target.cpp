#include "render/target.h"

#include "image/error.h"
#include "render/gl.h"
#include "render/gl_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sandbox {
namespace {

Texture make_target_texture(Size size, GLint format, GLenum layout, GLenum type, GLint filter) {
    Texture texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, format, size.width, size.height, 0, layout, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

void attach(GLenum point, const Texture &texture) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.id(), 0);
}

/// To the bound framebuffer.
Renderbuffer attach_depth(Size size, GLenum format) {
    Renderbuffer depth = make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, depth.id());
    glRenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
    return depth;
}

void require_complete(Size size) {
    check_gl(fmt::format("store a picture of {}x{}", size.width, size.height));
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw MachineError("the driver refuses to draw into a picture of {}x{} (status {:#06x})", size.width,
                           size.height, status);
    }
}

void require_possible(Size size) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (size.width < 1 || size.height < 1 || size.width > largest || size.height > largest) {
        throw MachineError("this driver draws pictures of 1x1 to {0}x{0}, not {1}x{2}", largest, size.width,
                           size.height);
    }
}

/// OpenGL's rows start at the bottom.
template <typename Pixel> void flip_rows(std::vector<Pixel> &pixels, Size size) {
    const auto width = static_cast<std::ptrdiff_t>(size.width);
    for (std::ptrdiff_t y = 0; y < size.height / 2; ++y) {
        const auto top = pixels.begin() + y * width;
        std::swap_ranges(top, top + width, pixels.begin() + (size.height - 1 - y) * width);
    }
}

} // namespace

Target::Target(Size size, bool object_ids) : size_(size) {
    require_possible(size);
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    color_ = make_target_texture(size, GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST);
    attach(GL_COLOR_ATTACHMENT0, color_);
    if (object_ids) {
        ids_ = make_target_texture(size, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, GL_NEAREST);
        attach(GL_COLOR_ATTACHMENT1, ids_);
    }
    depth_ = attach_depth(size, GL_DEPTH_COMPONENT32F);
    constexpr GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(object_ids ? 2 : 1, attachments);
    require_complete(size);
}

void Target::finish() const { finish_drawing(framebuffer(), GL_FLOAT); }
void Target::finish_in_turns() const { finish_drawing_in_turns(framebuffer(), GL_FLOAT); }

void Target::write_color(const Image &image) {
    std::vector<glm::vec4> bottom_first = image.pixels;
    flip_rows(bottom_first, size_);
    glBindTexture(GL_TEXTURE_2D, color_.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.width, size_.height, GL_RGBA, GL_FLOAT, bottom_first.data());
    check_gl("replace a picture");
}

template <typename Pixel>
std::vector<Pixel> Target::read_pixels(unsigned attachment, unsigned layout, unsigned type) const {
    std::vector<Pixel> pixels(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(attachment);
    glReadPixels(0, 0, size_.width, size_.height, layout, type, pixels.data());
    check_gl("read a picture back");
    flip_rows(pixels, size_);
    return pixels;
}

Image Target::read_color() const {
    Image image;
    image.size = size_;
    image.pixels = read_pixels<glm::vec4>(GL_COLOR_ATTACHMENT0, GL_RGBA, GL_FLOAT);
    return image;
}

std::vector<std::uint32_t> Target::read_object_ids() const {
    // ES reads all four or none.
    const auto pixels = read_pixels<glm::uvec4>(GL_COLOR_ATTACHMENT1, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
    std::vector<std::uint32_t> ids(pixels.size());
    std::ranges::transform(pixels, ids.begin(), [](const glm::uvec4 &pixel) { return pixel.x; });
    return ids;
}

Image Target::read_row(int y) const {
    Image row({size_.width, 1});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, size_.height - 1 - y, size_.width, 1, GL_RGBA, GL_FLOAT, row.pixels.data());
    check_gl("read a row back");
    return row;
}

glm::vec4 Target::read_pixel(int x, int y) const {
    glm::vec4 pixel(0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(x, size_.height - 1 - y, 1, 1, GL_RGBA, GL_FLOAT, &pixel);
    check_gl("read a pixel back");
    return pixel;
}

DisplayTexture::DisplayTexture(Size size) : size_(size) {
    require_possible(size);
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    color_ = make_target_texture(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST);
    attach(GL_COLOR_ATTACHMENT0, color_);
    require_complete(size);
}

void DisplayTexture::finish() const { finish_drawing(framebuffer(), GL_UNSIGNED_BYTE); }
void DisplayTexture::finish_in_turns() const { finish_drawing_in_turns(framebuffer(), GL_UNSIGNED_BYTE); }

DisplayTexture::DisplayTexture(const ByteImage &picture) : DisplayTexture(picture.size) {
    std::vector<std::array<std::uint8_t, 4>> bottom_first(picture.rgb.size() / 3);
    for (std::size_t i = 0; i < bottom_first.size(); ++i) { // ES takes as many channels as are stored
        bottom_first[i] = {picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2], 255};
    }
    flip_rows(bottom_first, size_);
    glBindTexture(GL_TEXTURE_2D, color_.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, bottom_first.data());
    check_gl("store a picture to show");
}

ScreenTarget::ScreenTarget(Size size) : color_(size) {
    glBindFramebuffer(GL_FRAMEBUFFER, color_.framebuffer());
    depth_ = attach_depth(size, GL_DEPTH_COMPONENT24);
    require_complete(size);
}

} // namespace sandbox
