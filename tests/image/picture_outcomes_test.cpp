#include "image/error.h"
#include "image/image_file.h"
#include "image/jpeg_bytes.h"
#include "image/png_bytes.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

using namespace std::string_literals;

/// What comes of a file: its size, then its pixels (of more than 8: the corners) with so many hexadecimal digits a
/// value, opacity only where it is not 1; or the message.
std::string outcome(const std::string &bytes, int digits) {
    try {
        const Image image = decode_image(bytes, "a");
        const auto [width, height] = image.size;
        const double most = std::pow(16, digits) - 1;
        const auto number = [&](float value) {
            return fmt::format("{:0{}x}", std::lround(static_cast<double>(value) * most), digits);
        };
        std::vector<glm::vec4> shown = image.pixels;
        if (shown.size() > 8) {
            shown = {image.at(0, 0), image.at(width - 1, 0), image.at(0, height - 1), image.at(width - 1, height - 1)};
        }
        std::string out = fmt::format("{}x{}", width, height);
        for (const glm::vec4 &pixel : shown) {
            out += " " + number(pixel.r) + number(pixel.g) + number(pixel.b);
            out += pixel.a == 1 ? "" : "/" + number(pixel.a);
        }
        return out;
    } catch (const InputError &error) {
        return error.what();
    }
}

struct Case {
    const char *what;
    int digits;
    std::string bytes, expected;
};

void expect_outcomes(const std::vector<Case> &cases) {
    for (const Case &c : cases) {
        EXPECT_EQ(outcome(c.bytes, c.digits), c.expected) << c.what;
    }
}

const std::string grey2 = png_header(2, 1, 8, png_grey);
const std::string grey2_rows = "\0\x40\xFF"s;
const std::string grey2_data = deflated(grey2_rows);
const std::string grey2_right = "2x1 404040 ffffff";
const std::string colors2 = png_header(2, 1, 8, png_palette);
const std::string two_colors = chunk("PLTE", "\x11\x22\x33\xAA\xBB\xCC");

std::string damaged(std::string bytes, std::size_t at) {
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    return bytes;
}

TEST(PictureOutcomes, OfPngsThatAreRight) {
    expect_outcomes({
        {"grey of 1 bit", 2, png_file(png_header(3, 1, 1, png_grey), "\0\xA0"s), "3x1 ffffff 000000 ffffff"},
        {"grey of 2 bits", 2, png_file(png_header(4, 1, 2, png_grey), "\0\x1B"s), "4x1 000000 555555 aaaaaa ffffff"},
        {"grey of 4 bits", 2, png_file(png_header(2, 1, 4, png_grey), "\0\x3F"s), "2x1 333333 ffffff"},
        {"grey of 8 bits", 2, png_file(grey2, grey2_rows), grey2_right},
        {"grey of 16 bits", 4, png_file(png_header(3, 1, 16, png_grey), "\0\0\1\1\0\xFF\xFE"s),
         "3x1 000100010001 010001000100 fffefffefffe"},
        {"grey, opacity", 2, png_file(png_header(1, 1, 8, png_grey_alpha), "\0\x40\x80"s), "1x1 404040/80"},
        {"grey, opacity of 16 bits", 4, png_file(png_header(1, 1, 16, png_grey_alpha), "\0\x12\x34\0\7"s),
         "1x1 123412341234/0007"},
        {"a grey that is transparent", 2, png_file(grey2 + chunk("tRNS", "\0\x40"s) + chunk("IDAT", grey2_data)),
         "2x1 404040/00 ffffff"},
        {"RGB", 2, png_file(png_header(1, 1, 8, png_rgb), "\0\1\2\3"s), "1x1 010203"},
        {"RGB of 16 bits", 4, png_file(png_header(1, 1, 16, png_rgb), "\0\0\1\2\3\xFF\0"s), "1x1 00010203ff00"},
        {"an RGB of 16 bits that is transparent", 4,
         png_file(png_header(1, 1, 16, png_rgb) + chunk("tRNS", "\0\1\2\3\xFF\0"s) +
                  chunk("IDAT", deflated("\0\0\1\2\3\xFF\0"s))),
         "1x1 00010203ff00/0000"},
        {"RGBA", 2, png_file(png_header(1, 1, 8, png_rgba), "\0\1\2\3\4"s), "1x1 010203/04"},
        {"RGBA of 16 bits", 4, png_file(png_header(1, 1, 16, png_rgba), "\0\0\1\0\2\0\3\0\4"s),
         "1x1 000100020003/0004"},
        {"a palette", 2, png_file(colors2 + two_colors + chunk("IDAT", deflated("\0\1\0"s))), "2x1 aabbcc 112233"},
        {"a palette with opacity", 2,
         png_file(colors2 + two_colors + chunk("tRNS", "\x44") + chunk("IDAT", deflated("\0\1\0"s))),
         "2x1 aabbcc 112233/44"},
        {"a palette of 1 bit", 2,
         png_file(png_header(2, 1, 1, png_palette) + two_colors + chunk("IDAT", deflated("\0\x40"s))),
         "2x1 112233 aabbcc"},
        {"interlaced", 2, png_file(png_header(2, 2, 8, png_grey, true), "\0\x0A\0\x0B\0\x0C\x0D"s),
         "2x2 0a0a0a 0b0b0b 0c0c0c 0d0d0d"},
        {"interlaced, 16 bits", 4, png_file(png_header(1, 2, 16, png_grey, true), "\0\0\x0A\0\0\x0C"s),
         "1x2 000a000a000a 000c000c000c"},
        {"every filter", 2,
         png_file(png_header(2, 4, 8, png_grey), "\1\x10\x05\2\x01\x01\3\x02\x00\4\x01\x01"s), // PNG 1.2, section 6
         "2x4 101010 151515 111111 161616 0a0a0a 101010 0b0b0b 111111"},
        {"data in parts", 2,
         png_file(grey2 + chunk("IDAT", grey2_data.substr(0, 3)) + chunk("IDAT", "") +
                  chunk("IDAT", grey2_data.substr(3))),
         grey2_right},
        {"more data than the rows", 2, png_file(grey2, grey2_rows + "more"), grey2_right},
        {"an unknown chunk", 2, png_file(grey2 + chunk("prVt", "x") + chunk("IDAT", grey2_data)), grey2_right},
        {"text with a wrong checksum", 2, png_file(grey2 + chunk("tEXt", "a\0b"s, false) + chunk("IDAT", grey2_data)),
         grey2_right},
        {"text after the data, too", 2, png_file(grey2 + chunk("IDAT", grey2_data) + chunk("tEXt", "a\0b"s, false)),
         grey2_right},
        {"bytes after the end", 2, png_file(grey2, grey2_rows) + "more", grey2_right},
        {"chunks after the end", 2, png_file(grey2, grey2_rows) + chunk("IDAT", "more"), grey2_right},
    });
}

TEST(PictureOutcomes, OfPngsThatAreRefused) {
    const std::string whole = png_file(grey2, grey2_rows);
    const std::size_t half = grey2_data.size() - 2;
    const std::string last = damaged(grey2_data, grey2_data.size() - 1);
    const auto data = [](const std::string &bytes) { return chunk("IDAT", bytes); };
    const std::string wrong_sum = "a: the end of the PNG file's pixel data is damaged (incorrect data check)";
    expect_outcomes({
        {"a wrong checksum of the pixels", 2, png_file(grey2 + data(last)), wrong_sum},
        {"one that begins in another chunk", 2, png_file(grey2 + data(last.substr(0, half)) + data(last.substr(half))),
         wrong_sum},
        {"none", 2, png_file(grey2 + data(grey2_data.substr(0, half - 2))),
         "a: the end of the PNG file's pixel data is damaged (its checksum is missing)"},
        {"a wrong checksum of the data's chunk", 2, png_file(grey2 + chunk("IDAT", grey2_data, false)),
         "a: cannot decode the PNG file (invalid chunk checksum)"},
        {"of the transparency", 2, png_file(grey2 + chunk("tRNS", "\0\x40"s, false) + data(grey2_data)),
         "a: the PNG file's transparency is damaged"},
        {"of the header", 2, damaged(whole, 32), "a: cannot decode the PNG file (invalid chunk checksum)"},
        {"a chunk within the data", 2,
         png_file(grey2 + data(grey2_data.substr(0, half)) + chunk("tEXt", "a\0b"s) + data(grey2_data.substr(half))),
         "a: another chunk stands within the PNG file's pixel data, whose chunks (IDAT) must follow each other"},
        {"far more data than the rows", 2, png_file(grey2, grey2_rows + std::string(2 << 20, '\0')),
         "a: the PNG file holds more data than its pixels need"},
        {"less", 2, png_file(grey2, grey2_rows.substr(0, 2)), "a: cannot decode the PNG file (IDAT stream too short)"},
        {"no data", 2, png_file(grey2), "a: cannot decode the PNG file (invalid chunk position)"},
        {"a filter that is none", 2, png_file(grey2, "\5\x40\xFF"),
         "a: cannot decode the PNG file (invalid scanline filter)"},
        {"a chunk that must be known", 2, png_file(grey2 + chunk("PRVT", "x") + data(grey2_data)),
         "a: cannot decode the PNG file (unknown critical chunk)"},
        {"a colour beyond the palette", 2, png_file(colors2 + two_colors + data(deflated("\0\1\2"s))),
         "a: pixel (1, 0) has colour 2 of a palette of 2"},
        {"no palette", 2, png_file(colors2 + data(deflated("\0\1\0"s))),
         "a: cannot decode the PNG file (missing PLTE for indexed image)"},
        {"Apple's form", 2, png_file(chunk("CgBI", "\x50\x20\x06\x02") + grey2 + data(grey2_data)),
         "a: a PNG in Apple's own form (CgBI), which is no standard one; export it as PNG again"},
        {"3 bits", 2, png_file(png_header(2, 1, 3, png_grey), grey2_rows),
         "a: cannot decode the PNG file (invalid bit depth)"},
        {"no width", 2, png_file(png_header(0, 1, 8, png_grey), grey2_rows),
         "a: cannot decode the PNG file (invalid image width)"},
        {"too wide", 2, png_file(png_header(8193, 1, 8, png_grey), grey2_rows), "a: more than 8192 pixels a side"},
        {"no end", 2, whole.substr(0, whole.size() - 12), "a: the PNG file ends too early"},
    });
}

using Fields = std::array<std::vector<unsigned char>, 4>;
const Fields colors{{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}}};
const std::string colors_right = "32x16 f00 0f0 00f fff";

JpegForm with_segments(std::vector<std::string> segments) {
    JpegForm form;
    form.segments = std::move(segments);
    return form;
}

// One digit a value, of fields whose values are whole numbers of it: JPEG at quality 100 is right to 2 levels of 255.
TEST(PictureOutcomes, OfJpegsThatAreRight) {
    const std::string plain = jpeg_file(colors, {});
    const std::size_t scan = jpeg_segment(plain, '\xda');
    const Fields greys{{{0}, {0x44}, {0x88}, {255}}};
    expect_outcomes({
        {"baseline", 1, plain, colors_right},
        {"chroma at half resolution", 1, jpeg_file(colors, {.chroma = 2}), colors_right},
        {"progressive", 1, jpeg_file(colors, {.progressive = true}), colors_right},
        {"arithmetic coding", 1, jpeg_file(colors, {.arithmetic = true}), colors_right},
        {"restarts", 1, jpeg_file(colors, {.restart = 2}), colors_right},
        {"stored as RGB", 1, jpeg_file(colors, {.stored = JCS_RGB, .adobe_marker = true}), colors_right},
        {"grey", 1, jpeg_file(greys, {.given = JCS_GRAYSCALE, .stored = JCS_GRAYSCALE}), "32x16 000 444 888 fff"},
        {"JFIF 3", 1, jpeg_file(colors, {.jfif_major = 3}), colors_right},
        {"a scan of coefficients 0 to 0", 1, with_byte(plain, scan + 8, '\0'), colors_right},
        {"bytes between segments", 1, std::string(plain).insert(jpeg_segment(plain, '\xdb') - 4, "xx"), colors_right},
        {"bytes after the end", 1, plain + "more", colors_right},
    });
}

TEST(PictureOutcomes, OfJpegsOfInks) {
    const Fields inks{{{0, 255, 255, 0}, {255, 0, 255, 0}, {0, 0, 0, 0}, {0, 136, 255, 136}}};
    Fields inverted = inks;
    for (std::vector<unsigned char> &field : inverted) {
        for (unsigned char &ink : field) {
            ink = static_cast<unsigned char>(255 - ink);
        }
    }
    const std::string right = "32x16 f00 0f0 fff 730"; // 7 of 15 are left of 136; 7 / 15 of 7 are 3
    expect_outcomes({
        {"CMYK", 1, jpeg_file(inks, {.given = JCS_CMYK, .stored = JCS_CMYK}), right},
        {"Adobe's CMYK", 1, jpeg_file(inverted, {.given = JCS_CMYK, .stored = JCS_CMYK, .adobe_marker = true}), right},
        {"Adobe's YCCK", 1, jpeg_file(inverted, {.given = JCS_CMYK, .stored = JCS_YCCK, .adobe_marker = true}), right},
        {"Adobe's YCCK, half chroma, progressive", 1,
         jpeg_file(inverted,
                   {.given = JCS_CMYK, .stored = JCS_YCCK, .adobe_marker = true, .progressive = true, .chroma = 2}),
         right},
    });
}

TEST(PictureOutcomes, OfJpegsThatSayHowTheyWereTaken) {
    const auto turned = [](std::vector<std::string> segments) {
        return jpeg_file(colors, with_segments(std::move(segments)));
    };
    const std::string xmp = "http://ns.adobe.com/xap/1.0/\0<x/>"s;
    const std::string clockwise = "16x32 00f f00 fff 0f0";
    expect_outcomes({
        {"as it stands", 1, turned({exif_segment(1)}), colors_right},
        {"mirrored", 1, turned({exif_segment(2)}), "32x16 0f0 f00 fff 00f"},
        {"half a turn", 1, turned({exif_segment(3)}), "32x16 fff 00f 0f0 f00"},
        {"upside down, mirrored", 1, turned({exif_segment(4)}), "32x16 00f fff f00 0f0"},
        {"transposed", 1, turned({exif_segment(5)}), "16x32 f00 00f 0f0 fff"},
        {"clockwise", 1, turned({exif_segment(6)}), clockwise},
        {"transposed the other way", 1, turned({exif_segment(7)}), "16x32 fff 0f0 00f f00"},
        {"counter-clockwise", 1, turned({exif_segment(8)}), "16x32 0f0 fff f00 00f"},
        {"little endian", 1, turned({exif_segment(6, false)}), clockwise},
        {"after other data", 1, turned({xmp, exif_segment(6)}), clockwise},
        {"the first counts", 1, turned({exif_segment(6), exif_segment(3)}), clockwise},
        {"0 is no orientation", 1, turned({exif_segment(0)}), colors_right},
        {"nor is 9", 1, turned({exif_segment(9)}), colors_right},
        {"cut short", 1, turned({exif_segment(6).substr(0, 20)}), colors_right},
        {"a directory beyond the end", 1, turned({"Exif\0\0MM\0\x2A\xFF\xFF\xFF\xF0"s}), colors_right},
    });
}

TEST(PictureOutcomes, OfJpegsThatAreRefused) {
    const std::string plain = jpeg_file(colors, {});
    const std::size_t frame = jpeg_segment(plain, '\xc0');
    const auto refused = [](const std::string &why) { return "a: cannot decode the JPEG file (" + why + ")"; };
    const std::string expected = "; expected 8 bits a value, baseline or progressive";
    expect_outcomes({
        {"12 bits", 1, with_byte(plain, frame, 12), refused("it has more than 8 bits a value" + expected)},
        {"lossless", 1, with_byte(plain, frame - 3, '\xc3'), refused("its compression is lossless" + expected)},
        {"hierarchical", 1, with_byte(plain, frame - 3, '\xc5'), refused("its compression is hierarchical" + expected)},
        {"no height", 1, with_byte(plain, frame + 2, 0), refused("Empty JPEG image (DNL not supported)")},
        {"too wide", 1, with_byte(plain, frame + 3, '\x7f'), refused("more than 8192 pixels a side")},
        {"no end", 1, plain.substr(0, plain.size() - 2), refused("Premature end of JPEG file")},
        {"no scan", 1, plain.substr(0, jpeg_segment(plain, '\xda') - 4) + "\xff\xd9",
         refused("Invalid JPEG file structure: missing SOS marker")},
    });
}

TEST(PictureOutcomes, OfOtherFiles) {
    expect_outcomes({
        {"nothing", 1, "", "a: expected a PNG or JPEG image, got an empty file"},
        {"a GIF", 1, "GIF89a", "a: expected a PNG or JPEG image, got another kind of file"},
    });
}

} // namespace
} // namespace sandbox
