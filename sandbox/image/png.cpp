#include "image/codecs.h"
#include "image/error.h"
#include "image/image_file.h"

#include <array>
#include <cstdlib>
#include <memory>

namespace {

// The most a picture of 8192 x 8192 can need (16-bit RGBA and its filter bytes). A small file can ask zlib for far
// more.
constexpr std::size_t decoder_limit = std::size_t{8192} * 8192 * 8 + 8192;

void *limited_malloc(std::size_t size) { return size > decoder_limit ? nullptr : std::malloc(size); }
void *limited_realloc(void *block, std::size_t size) {
    return size > decoder_limit ? nullptr : std::realloc(block, size);
}

} // namespace

#define STBI_MALLOC(size) limited_malloc(size)
#define STBI_REALLOC(block, size) limited_realloc(block, size)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace sandbox {
namespace {

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// CRC-32 as in annex D of the PNG specification.
std::uint32_t crc32(std::string_view bytes) {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> made{};
        for (std::uint32_t n = 0; n < 256; ++n) {
            std::uint32_t c = n;
            for (int bit = 0; bit < 8; ++bit) {
                c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
            }
            made[n] = c;
        }
        return made;
    }();
    std::uint32_t crc = 0xffffffffU;
    for (const char byte : bytes) {
        crc = table[(crc ^ static_cast<unsigned char>(byte)) & 0xffU] ^ (crc >> 8);
    }
    return ~crc;
}

/// The decoder skips checksums; without this a damaged file would become a plausible picture.
void check_chunks(std::string_view bytes, const std::string &name) {
    for (std::size_t at = png_signature.size();;) {
        if (bytes.size() - at < 12 || big_endian(bytes, at) > bytes.size() - at - 12) {
            throw InputError(name + ": the PNG file ends too early");
        }
        const std::size_t length = big_endian(bytes, at);
        const std::string_view kind = bytes.substr(at + 4, 4);
        if (crc32(bytes.substr(at + 4, length + 4)) != big_endian(bytes, at + 8 + length)) {
            throw InputError(name + ": the PNG file is damaged (a checksum is wrong)");
        }
        if (kind == "IEND") {
            return;
        }
        at += length + 12;
    }
}

void append(void *context, void *data, int size) {
    static_cast<std::string *>(context)->append(static_cast<const char *>(data), static_cast<std::size_t>(size));
}

} // namespace

Image decode_png(std::string_view bytes, std::string_view name) {
    const std::string file(name);
    if (bytes.size() > decoder_limit) {
        throw InputError(file + ": the PNG file is too large");
    }
    check_chunks(bytes, file);
    Size size;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&std::free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc *>(bytes.data()), static_cast<int>(bytes.size()),
                              &size.width, &size.height, &channels, 4),
        std::free);
    if (!pixels) {
        const std::string reason = stbi_failure_reason();
        throw InputError(file + (reason == "too large" ? ": more than 8192 pixels a side"
                                                       : ": cannot decode the PNG file (" + reason + ")"));
    }
    return from_bytes(size, pixels.get(), 4);
}

std::string encode_png(const ByteImage &image) {
    std::string bytes;
    if (stbi_write_png_to_func(append, &bytes, image.size.width, image.size.height, 3, image.rgb.data(),
                               image.size.width * 3) == 0) {
        throw std::bad_alloc();
    }
    return bytes;
}

} // namespace sandbox
