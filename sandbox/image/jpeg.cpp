#include "image/jpeg.h"

#include "image/error.h"
#include "image/exif.h"

#include <csetjmp>
#include <cstdio>
#include <glm/vec3.hpp>
#include <vector>

#include <jerror.h>
#include <jpeglib.h>

namespace sandbox {
namespace {

/// libjpeg's own error handler ends the process; this one jumps back with the message.
struct Decoder {
    jpeg_decompress_struct info{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf back{};
    char message[JMSG_LENGTH_MAX] = {};
};

/// Forms that libjpeg knows by name only: why, in plain words. Null: its own message says enough.
const char *unknown_form(const jpeg_error_mgr &errors) {
    if (errors.msg_code == JERR_BAD_PRECISION) {
        return "it has more than 8 bits a value";
    }
    if (errors.msg_code == JERR_SOF_UNSUPPORTED) {
        const int process = errors.msg_parm.i[0];
        return process == 0xC3 || process == 0xCB ? "its compression is lossless" : "its compression is hierarchical";
    }
    return nullptr;
}

[[noreturn]] void fail(j_common_ptr info) {
    auto *decoder = static_cast<Decoder *>(info->client_data);
    if (const char *form = unknown_form(*info->err)) {
        std::snprintf(decoder->message, sizeof decoder->message, "%s; expected 8 bits a value, baseline or progressive",
                      form);
    } else {
        info->err->format_message(info, decoder->message);
    }
    std::longjmp(decoder->back, 1);
}

/// A warning means damage that libjpeg would paint over, but for three: stray bytes between markers; a sequential
/// scan's range of coefficients, which is always all of them, whatever it says (Samsung's cameras say 0 to 0); a JFIF
/// header of another revision, of which only the resolution is read.
void refuse_damage(j_common_ptr info, int level) {
    const int code = info->err->msg_code;
    if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_NOT_SEQUENTIAL && code != JWRN_JFIF_MAJOR) {
        fail(info);
    }
}

/// A small progressive file can hold thousands of scans, each a pass over the whole picture.
void refuse_many_scans(j_common_ptr info) {
    auto *decoder = static_cast<Decoder *>(info->client_data);
    if (decoder->info.input_scan_number > 500) {
        std::snprintf(decoder->message, sizeof decoder->message, "more than 500 scans");
        std::longjmp(decoder->back, 1);
    }
}

/// A picture as it stands in the file.
struct Samples {
    Size size;
    std::size_t channels = 3; ///< red, green, blue; 4: cyan, magenta, yellow, black
    bool inverted = false;    ///< inks: 255 is none of it, as Adobe's programs write them
    Orientation orientation;
    std::vector<unsigned char> bytes;
};

/// False: decoder.message says why. No object with a destructor may live here, for the jump would skip it.
bool decode(Decoder &decoder, std::string_view bytes, Samples &samples) {
    jpeg_decompress_struct &info = decoder.info;
    info.err = jpeg_std_error(&decoder.errors);
    decoder.errors.error_exit = fail;
    decoder.errors.emit_message = refuse_damage;
    decoder.progress.progress_monitor = refuse_many_scans;
    info.client_data = &decoder;
    if (setjmp(decoder.back) != 0) {
        return false;
    }
    jpeg_create_decompress(&info);
    info.client_data = &decoder;
    info.progress = &decoder.progress;
    jpeg_save_markers(&info, JPEG_APP0 + 1, 0xFFFF);
    jpeg_mem_src(&info, reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size());
    jpeg_read_header(&info, TRUE);
    if (info.image_width > max_image_side || info.image_height > max_image_side) {
        std::snprintf(decoder.message, sizeof decoder.message, "more than %d pixels a side", max_image_side);
        return false;
    }
    for (jpeg_saved_marker_ptr segment = info.marker_list; segment != nullptr; segment = segment->next) {
        const auto found = exif_orientation({reinterpret_cast<const char *>(segment->data), segment->data_length});
        if (found) {
            samples.orientation = *found;
            break;
        }
    }
    const bool inks = info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
    info.out_color_space = inks ? JCS_CMYK : JCS_RGB;
    samples.channels = inks ? 4 : 3;
    samples.inverted = info.saw_Adobe_marker != 0;
    jpeg_start_decompress(&info);
    samples.size = {static_cast<int>(info.output_width), static_cast<int>(info.output_height)};
    const std::size_t stride = std::size_t{info.output_width} * samples.channels;
    samples.bytes.resize(stride * info.output_height);
    while (info.output_scanline < info.output_height) {
        unsigned char *row = samples.bytes.data() + stride * info.output_scanline;
        jpeg_read_scanlines(&info, &row, 1);
    }
    jpeg_finish_decompress(&info);
    return true;
}

/// What each ink leaves of white light, times what black leaves: no colour profile is looked at.
glm::vec4 light_of_inks(const unsigned char *inks, bool inverted) {
    const auto left = [&](int ink) { return static_cast<float>(inverted ? inks[ink] : 255 - inks[ink]); };
    return {glm::vec3(left(0), left(1), left(2)) * left(3) / (255.F * 255.F), 1};
}

Image upright(const Samples &samples) {
    const auto [width, height] = samples.size;
    const auto [transposed, from_right, from_bottom] = samples.orientation;
    Image image(transposed ? Size{height, width} : samples.size);
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            const int column = transposed ? y : x;
            const int row = transposed ? x : y;
            const auto from_column = static_cast<std::size_t>(from_right ? width - 1 - column : column);
            const auto from_row = static_cast<std::size_t>(from_bottom ? height - 1 - row : row);
            const unsigned char *pixel =
                samples.bytes.data() + (from_row * static_cast<std::size_t>(width) + from_column) * samples.channels;
            image.at(x, y) = samples.channels == 4
                                 ? light_of_inks(pixel, samples.inverted)
                                 : glm::vec4(static_cast<float>(pixel[0]) / 255.F, static_cast<float>(pixel[1]) / 255.F,
                                             static_cast<float>(pixel[2]) / 255.F, 1);
        }
    }
    return image;
}

} // namespace

Image decode_jpeg(std::string_view bytes, std::string_view name) {
    Decoder decoder;
    Samples samples;
    const bool good = decode(decoder, bytes, samples);
    jpeg_destroy_decompress(&decoder.info);
    if (!good) {
        throw InputError("{}: cannot decode the JPEG file ({})", name, decoder.message);
    }
    return upright(samples);
}

} // namespace sandbox
