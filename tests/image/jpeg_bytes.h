#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <jpeglib.h>

/// JPEG files of any form that libjpeg writes, and what changes them into forms that it does not.
namespace sandbox {

struct JpegForm {
    J_COLOR_SPACE given = JCS_RGB;    ///< of the corners' values
    J_COLOR_SPACE stored = JCS_YCbCr; ///< in the file
    bool adobe_marker = false;
    bool progressive = false;
    bool arithmetic = false;
    int chroma = 1; ///< pixels a side for each value of chroma
    unsigned restart = 0;
    unsigned char jfif_major = 1;
    std::vector<std::string> segments{}; ///< APP1
};

/// 32x16 pixels in four flat fields: their values from left to right, top to bottom. Quality 100.
inline std::string jpeg_file(const std::array<std::vector<unsigned char>, 4> &fields, const JpegForm &form) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char *bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &bytes, &size);
    info.image_width = 32;
    info.image_height = 16;
    info.input_components = static_cast<int>(fields[0].size());
    info.in_color_space = form.given;
    jpeg_set_defaults(&info);
    jpeg_set_colorspace(&info, form.stored);
    jpeg_set_quality(&info, 100, TRUE);
    info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = form.chroma;
    if (info.num_components == 4) {
        info.comp_info[3].h_samp_factor = info.comp_info[3].v_samp_factor = form.chroma;
    }
    info.write_Adobe_marker = form.adobe_marker ? TRUE : FALSE;
    info.JFIF_major_version = form.jfif_major;
    info.arith_code = form.arithmetic ? TRUE : FALSE;
    info.restart_interval = form.restart;
    if (form.progressive) {
        jpeg_simple_progression(&info);
    }
    jpeg_start_compress(&info, TRUE);
    for (const std::string &segment : form.segments) {
        jpeg_write_marker(&info, JPEG_APP0 + 1, reinterpret_cast<const JOCTET *>(segment.data()),
                          static_cast<unsigned>(segment.size()));
    }
    for (std::size_t y = 0; y < 16; ++y) {
        std::vector<unsigned char> row;
        for (std::size_t x = 0; x < 32; ++x) {
            const auto &values = fields[(y < 8 ? 0 : 2) + (x < 16 ? 0 : 1)];
            row.insert(row.end(), values.begin(), values.end());
        }
        unsigned char *line = row.data();
        jpeg_write_scanlines(&info, &line, 1);
    }
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    std::string out(reinterpret_cast<const char *>(bytes), size);
    std::free(bytes);
    return out;
}

/// Where the contents of the file's first segment of that marker begin, past its length.
inline std::size_t jpeg_segment(const std::string &file, char marker) { return file.find({'\xff', marker}) + 4; }
/// Without an entropy code that looks so, for the markers here stand before the scan.
inline std::string with_byte(std::string file, std::size_t at, char value) {
    file[at] = value;
    return file;
}

/// EXIF data in a TIFF structure of either byte order, of one entry: the orientation.
inline std::string exif_segment(int orientation, bool big_endian = true) {
    using namespace std::string_literals;
    const char value = static_cast<char>(orientation);
    return "Exif\0\0"s +
           (big_endian ? "MM\0\x2A\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0"s + value + "\0\0"s
                       : "II\x2A\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0"s + value + "\0\0\0"s) +
           "\0\0\0\0"s;
}

} // namespace sandbox
