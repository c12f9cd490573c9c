#include "render/target.h"

#include "image/error.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

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

void require_complete(Size size) {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    const GLenum error = glGetError();
    if (status != GL_FRAMEBUFFER_COMPLETE || error != GL_NO_ERROR) {
        throw MachineError("the driver refuses a float target of " + std::to_string(size.width) + "x" +
                           std::to_string(size.height) + " (status " + std::to_string(status) + ", error " +
                           std::to_string(error) + ")");
    }
}

void require_possible(Size size) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (size.width < 1 || size.height < 1 || size.width > largest || size.height > largest) {
        throw MachineError("this driver draws pictures of 1x1 to " + std::to_string(largest) + "x" +
                           std::to_string(largest) + ", not " + std::to_string(size.width) + "x" +
                           std::to_string(size.height));
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
    depth_ = make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    constexpr GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(object_ids ? 2 : 1, attachments);
    require_complete(size);
}

void Target::write_color(const Image &image) {
    std::vector<glm::vec4> bottom_first = image.pixels;
    flip_rows(bottom_first, size_);
    glBindTexture(GL_TEXTURE_2D, color_.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.width, size_.height, GL_RGBA, GL_FLOAT, bottom_first.data());
}

Image Target::read_color() const {
    Image image(size_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_FLOAT, image.pixels.data());
    flip_rows(image.pixels, size_);
    return image;
}

glm::vec4 Target::read_pixel(int x, int y) const {
    glm::vec4 pixel(0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(x, size_.height - 1 - y, 1, 1, GL_RGBA, GL_FLOAT, &pixel);
    return pixel;
}

std::vector<std::uint32_t> Target::read_object_ids() const {
    std::vector<std::uint32_t> ids(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glReadPixels(0, 0, size_.width, size_.height, GL_RED_INTEGER, GL_UNSIGNED_INT, ids.data());
    flip_rows(ids, size_);
    return ids;
}

DisplayTexture::DisplayTexture(Size size) : size_(size) {
    require_possible(size);
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    color_ = make_target_texture(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST);
    attach(GL_COLOR_ATTACHMENT0, color_);
    require_complete(size);
}

DisplayTexture::DisplayTexture(const ByteImage &picture) : DisplayTexture(picture.size) {
    std::vector<std::array<std::uint8_t, 3>> bottom_first(picture.rgb.size() / 3);
    std::memcpy(bottom_first.data(), picture.rgb.data(), picture.rgb.size());
    flip_rows(bottom_first, size_);
    glBindTexture(GL_TEXTURE_2D, color_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); // rows of three bytes a pixel
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.width, size_.height, GL_RGB, GL_UNSIGNED_BYTE, bottom_first.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

} // namespace sandbox
