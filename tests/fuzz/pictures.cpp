#include "capture/picture.h"
#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "image/image_file.h"
#include "image/jpeg.h"
#include "measure/diagnosis/levels.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace sandbox {
namespace {

/// Larger ones only take longer.
constexpr std::size_t most_pixels = std::size_t{1} << 18;

std::size_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = at; i < at + count; ++i) {
        value = value << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    }
    return value;
}

bool is_large(std::size_t width, std::size_t height) {
    constexpr auto side = static_cast<std::size_t>(max_image_side); // beyond it: refused at once
    return width <= side && height <= side && width * height > most_pixels;
}

/// By any of its frame headers.
bool is_large_jpeg(std::string_view bytes) {
    for (std::size_t at = 0; at + 9 < bytes.size(); ++at) {
        const bool frame = bytes[at] == '\xff' && (static_cast<unsigned char>(bytes[at + 1]) & 0xf0U) == 0xc0U;
        if (frame && is_large(big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2))) {
            return true;
        }
    }
    return false;
}

void held_picture(const Image &image) {
    const Size size = image.size;
    held(size.width >= 1 && size.height >= 1 && size.width <= max_image_side && size.height <= max_image_side,
         "a picture has 1 to max_image_side pixels a side");
    held(image.pixels.size() == static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
         "a picture has all of its pixels");
}

void held_numbers(const Image &image) {
    for (const glm::vec4 &pixel : image.pixels) {
        for (int i = 0; i < 4; ++i) {
            held(pixel[i] >= 0 && pixel[i] <= 1, "a picture's numbers are from 0 to 1");
        }
    }
    const ByteImage shown = to_display(image);
    held(to_display(decode_png(encode_png(shown), "again.png")).rgb == shown.rgb, "a PNG reads back as it was");
}

} // namespace

void check_png(std::string_view bytes) {
    if (is_large(big_endian(bytes, 16, 4), big_endian(bytes, 20, 4))) {
        return;
    }
    // As a texture is, whatever it begins with: the target's own mutations keep the signature.
    if (const auto image = accepted([&] { return decode_image(bytes, "a.png"); })) {
        held_picture(*image);
        held_numbers(*image);
    }
}

void check_jpeg(std::string_view bytes) {
    if (is_large_jpeg(bytes)) {
        return;
    }
    if (const auto image = accepted([&] { return decode_jpeg(bytes, "a.jpg"); })) {
        held_picture(*image);
        held_numbers(*image);
    }
}

void check_pfm(std::string_view bytes) {
    // What is handed in to be diagnosed or marked.
    const auto observed = accepted([&] { return decode_observed(bytes, "a.pfm"); });
    const auto image = accepted([&] { return decode_pfm(bytes, "a.pfm"); });
    if (!image) {
        return;
    }
    held(observed && !observed->bytes, "a PFM is a picture that may be diagnosed");
    held(image->size.width >= 1 && image->size.height >= 1, "a picture has a pixel");
    const std::string written = encode_pfm(*image);
    held(encode_pfm(decode_pfm(written, "again.pfm")) == written, "a PFM reads back as it was");
    held(to_display(*image, Display::srgb, 2).rgb.size() == image->pixels.size() * 3, "it can be shown");
    for (const Reading reading : {Reading{}, Reading{Encoding::srgb, true, true}}) {
        held(observed_levels(*observed, reading).size() == image->pixels.size() * 3, "it has levels");
    }
}

std::vector<std::string> png_seeds() {
    ByteImage ramp{{3, 2}, std::vector<std::uint8_t>(18)};
    for (std::size_t i = 0; i < ramp.rgb.size(); ++i) {
        ramp.rgb[i] = static_cast<std::uint8_t>(i * 15);
    }
    std::vector<std::string> seeds{encode_png(ramp), encode_png({{1, 1}, {255, 0, 0}})};
    std::ranges::copy(kept_inputs("seeds", "png"), std::back_inserter(seeds));
    return seeds;
}

std::vector<std::string> jpeg_seeds() {
    std::vector<std::string> seeds = files_in("tests/data", ".jpg");
    std::ranges::copy(kept_inputs("seeds", "jpeg"), std::back_inserter(seeds));
    return seeds;
}

std::vector<std::string> pfm_seeds() {
    Image image({3, 2}, {0.5F, 2, -1, 1});
    image.at(1, 1) = {std::bit_cast<float>(0x7f800000U), 1e-40F, 0, 1};
    using namespace std::string_literals;
    return {encode_pfm(image), "Pf\n2 1\n1.0\n\x3f\x80\0\0\x40\0\0\0"s, "PF 1 1 -1\n\0\0\x80\x3f\0\0\xc0\x7f\0\0\0\0"s};
}

} // namespace sandbox
