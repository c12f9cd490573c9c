#include "image/jpeg.h"

#include "image/error.h"

#include <csetjmp>
#include <cstdio>
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

[[noreturn]] void fail(j_common_ptr info) {
    auto *decoder = static_cast<Decoder *>(info->client_data);
    info->err->format_message(info, decoder->message);
    std::longjmp(decoder->back, 1);
}

/// A warning means damage that libjpeg would paint over. Stray bytes between markers do no harm.
void refuse_damage(j_common_ptr info, int level) {
    if (level < 0 && info->err->msg_code != JWRN_EXTRANEOUS_DATA) {
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

/// False: decoder.message says why. No object with a destructor may live here, for the jump would skip it.
bool decode(Decoder &decoder, std::string_view bytes, std::vector<unsigned char> &rgb, Size &size) {
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
    jpeg_mem_src(&info, reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size());
    jpeg_read_header(&info, TRUE);
    if (info.image_width > max_image_side || info.image_height > max_image_side) {
        std::snprintf(decoder.message, sizeof decoder.message, "more than %d pixels a side", max_image_side);
        return false;
    }
    info.out_color_space = JCS_RGB;
    jpeg_start_decompress(&info);
    size = {static_cast<int>(info.output_width), static_cast<int>(info.output_height)};
    const std::size_t stride = std::size_t{info.output_width} * 3;
    rgb.resize(stride * info.output_height);
    while (info.output_scanline < info.output_height) {
        unsigned char *row = rgb.data() + stride * info.output_scanline;
        jpeg_read_scanlines(&info, &row, 1);
    }
    jpeg_finish_decompress(&info);
    return true;
}

} // namespace

Image decode_jpeg(std::string_view bytes, std::string_view name) {
    Decoder decoder;
    std::vector<unsigned char> rgb;
    Size size;
    const bool good = decode(decoder, bytes, rgb, size);
    jpeg_destroy_decompress(&decoder.info);
    if (!good) {
        throw InputError("{}: cannot decode the JPEG file ({})", name, decoder.message);
    }
    return from_bytes(size, rgb.data(), 3);
}

} // namespace sandbox
