#include "image/png.h"

#include "image/error.h"
#include "image/png_chunks.h"
#include "image/thread.h"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <spng.h>
#include <vector>

namespace sandbox {
namespace {

using Coder = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

// Of text and colour profiles, which a small file can inflate without end.
constexpr std::size_t most_metadata = std::size_t{64} << 20;
constexpr std::size_t most_needless_data = std::size_t{1} << 20; // beyond the last pixel

Coder make_coder(int flags) {
    Coder coder(spng_ctx_new(flags), spng_ctx_free);
    if (!coder) {
        throw std::bad_alloc();
    }
    return coder;
}

void check(int error, std::string_view name) {
    switch (error) {
    case SPNG_OK:
        return;
    case SPNG_EMEM:
        throw std::bad_alloc();
    case SPNG_EUSER_WIDTH:
    case SPNG_EUSER_HEIGHT:
        throw InputError("{}: more than {} pixels a side", name, max_image_side);
    case SPNG_IO_EOF:
        throw InputError("{}: the PNG file ends too early", name);
    default:
        throw InputError("{}: cannot decode the PNG file ({})", name, spng_strerror(error));
    }
}

/// Row after row into `pixels`, `length` bytes for `rows` of them.
void decode_rows(spng_ctx *decoder, spng_format format, int flags, void *pixels, std::size_t length, std::size_t rows,
                 std::string_view name) {
    check(spng_decode_image(decoder, nullptr, 0, format, flags | SPNG_DECODE_PROGRESSIVE), name);
    const std::size_t row_length = length / rows;
    int error = SPNG_OK;
    while (error == SPNG_OK) {
        spng_row_info row{};
        check(spng_get_row_info(decoder, &row), name);
        error = spng_decode_row(decoder, static_cast<unsigned char *>(pixels) + row.row_num * row_length, row_length);
        let_others_run();
    }
    check(error == SPNG_EOI ? SPNG_OK : error, name);
}

/// The pixels as red, green, blue and opacity. `format`: SPNG_FMT_RGBA8 or SPNG_FMT_RGBA16.
template <class Sample>
std::vector<Sample> decode_rgba(spng_ctx *decoder, spng_format format, std::size_t rows, std::string_view name) {
    std::size_t length = 0;
    check(spng_decoded_image_size(decoder, format, &length), name);
    std::vector<Sample> rgba(length / sizeof(Sample));
    decode_rows(decoder, format, SPNG_DECODE_TRNS, rgba.data(), length, rows, name);
    return rgba;
}

/// The same, 8 bits each, of a picture with a palette. Decoded here: libspng takes a colour that was never written for
/// an index beyond the palette's end.
std::vector<unsigned char> decode_palette(spng_ctx *decoder, const spng_ihdr &header, std::string_view name) {
    std::size_t length = 0;
    check(spng_decoded_image_size(decoder, SPNG_FMT_RAW, &length), name);
    std::vector<unsigned char> packed(length);
    decode_rows(decoder, SPNG_FMT_RAW, 0, packed.data(), length, header.height, name);
    spng_plte palette{};
    check(spng_get_plte(decoder, &palette), name);
    spng_trns opacity{};
    if (spng_get_trns(decoder, &opacity) != SPNG_OK) {
        opacity.n_type3_entries = 0;
    }
    std::vector<unsigned char> rgba;
    rgba.reserve(std::size_t{header.width} * header.height * 4);
    const unsigned depth = header.bit_depth;
    const std::size_t row = length / header.height;
    for (std::size_t y = 0; y < header.height; ++y) {
        let_others_run();
        for (std::size_t x = 0; x < header.width; ++x) {
            const std::size_t bit = x * depth;
            const unsigned byte = packed[y * row + bit / 8];
            const unsigned index = byte >> (8 - depth - bit % 8) & ((1U << depth) - 1);
            if (index >= palette.n_entries) {
                throw InputError("{}: pixel ({}, {}) has colour {} of a palette of {}", name, x, y, index,
                                 palette.n_entries);
            }
            const spng_plte_entry &color = palette.entries[index];
            const unsigned char alpha = index < opacity.n_type3_entries ? opacity.type3_alpha[index] : 255;
            rgba.insert(rgba.end(), {color.red, color.green, color.blue, alpha});
        }
    }
    return rgba;
}

/// Each of the values, red, green, blue and opacity, divided by 65535.
Image from_words(Size size, const std::vector<std::uint16_t> &words) {
    Image image(size);
    auto word = words.begin();
    for (glm::vec4 &pixel : image.pixels) {
        for (int channel = 0; channel < 4; ++channel) {
            pixel[channel] = static_cast<float>(*word++) / 65535.0F;
        }
    }
    return image;
}

} // namespace

Image decode_png(std::string_view bytes, std::string_view name) {
    if (has_png_chunk(bytes, "CgBI")) {
        throw InputError("{}: a PNG in Apple's own form (CgBI), which is no standard one; export it as PNG again",
                         name);
    }
    if (png_data_is_split(bytes)) {
        throw InputError(
            "{}: another chunk stands within the PNG file's pixel data, whose chunks (IDAT) must follow each "
            "other",
            name);
    }
    // libspng sees the checksum of all pixels only where the last chunk of data holds more than that, so it is looked
    // at below.
    const Coder decoder = make_coder(SPNG_CTX_IGNORE_ADLER32);
    check(spng_set_image_limits(decoder.get(), max_image_side, max_image_side), name);
    check(spng_set_chunk_limits(decoder.get(), most_metadata, most_metadata), name);
    check(spng_set_crc_action(decoder.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD), name);
    check(spng_set_png_buffer(decoder.get(), bytes.data(), bytes.size()), name);
    spng_ihdr header{};
    check(spng_get_ihdr(decoder.get(), &header), name);
    const Size size{static_cast<int>(header.width), static_cast<int>(header.height)};
    Image image;
    if (header.color_type == SPNG_COLOR_TYPE_INDEXED) {
        image = from_bytes(size, decode_palette(decoder.get(), header, name).data(), 4);
    } else if (header.bit_depth == 16) {
        image = from_words(size, decode_rgba<std::uint16_t>(decoder.get(), SPNG_FMT_RGBA16, header.height, name));
    } else {
        image =
            from_bytes(size, decode_rgba<unsigned char>(decoder.get(), SPNG_FMT_RGBA8, header.height, name).data(), 4);
    }
    spng_trns opacity{};
    if (has_png_chunk(bytes, "tRNS") && spng_get_trns(decoder.get(), &opacity) != SPNG_OK) {
        throw InputError("{}: the PNG file's transparency is damaged", name);
    }
    check(spng_decode_chunks(decoder.get()), name); // what follows the picture may be damaged, too
    // libspng does not miss the checksum (4 bytes, as the type) of the last chunk.
    check(bytes.size() < bytes.rfind("IEND") + 8 ? SPNG_IO_EOF : SPNG_OK, name);
    std::size_t raw = 0;
    check(spng_decoded_image_size(decoder.get(), SPNG_FMT_RAW, &raw), name);
    check_png_data(bytes, raw + most_needless_data, name);
    return image;
}

std::string encode_png(const ByteImage &image) {
    const Coder encoder = make_coder(SPNG_CTX_ENCODER);
    spng_ihdr header{};
    header.width = static_cast<std::uint32_t>(image.size.width);
    header.height = static_cast<std::uint32_t>(image.size.height);
    header.bit_depth = 8;
    header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
    check(spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1), "PNG");
    check(spng_set_option(encoder.get(), SPNG_IMG_COMPRESSION_LEVEL, 3), "PNG"); // half the time, a fifth more bytes
    check(spng_set_ihdr(encoder.get(), &header), "PNG");
    check(spng_encode_image(encoder.get(), nullptr, 0, SPNG_FMT_PNG, SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE),
          "PNG");
    const std::size_t row = std::size_t{3} * header.width;
    for (std::size_t y = 0; y < header.height; ++y) {
        let_others_run();
        const int end = y + 1 < header.height ? SPNG_OK : SPNG_EOI;
        const int error = spng_encode_row(encoder.get(), image.rgb.data() + y * row, row);
        check(error == end ? SPNG_OK : error, "PNG");
    }
    std::size_t length = 0;
    int error = SPNG_OK;
    const std::unique_ptr<void, decltype(&std::free)> bytes(spng_get_png_buffer(encoder.get(), &length, &error),
                                                            std::free);
    check(error, "PNG");
    return {static_cast<const char *>(bytes.get()), length};
}

} // namespace sandbox
