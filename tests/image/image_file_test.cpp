#include "image/image_file.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <cstdint>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

ByteImage small_picture() { return {{2, 2}, {255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30}}; }
std::string data_file(const std::string &name) { return read_file(fs::path(TEST_DATA_DIR) / name); }
std::string decoding_error(const std::string &bytes) {
    return error_of([&] { decode_image(bytes, "a.png"); });
}

TEST(Png, ReadsBackWhatWasWritten) {
    const Image back = decode_image(encode_png(small_picture()), "a.png");
    EXPECT_EQ(back.size, (Size{2, 2}));
    EXPECT_EQ(back.at(0, 0), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(back.at(0, 1), glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(back.at(1, 1), glm::vec4(10 / 255.F, 20 / 255.F, 30 / 255.F, 1));
    EXPECT_EQ(to_display(back).rgb, small_picture().rgb);
}

TEST(Png, RefusesAFileThatEndsEarly) {
    const std::string whole = encode_png(small_picture());
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_NE(decoding_error(whole.substr(0, length)), "no error") << length;
    }
    EXPECT_EQ(decoding_error(whole.substr(0, 40)), "a.png: the PNG file ends too early");
}

TEST(Png, RefusesAnyChangedBit) {
    const std::string whole = encode_png(small_picture());
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            EXPECT_NE(decoding_error(damaged), "no error") << at << " " << bit;
        }
    }
}

TEST(Png, RefusesMoreThan8192PixelsASide) {
    const ByteImage wide{{8193, 1}, std::vector<std::uint8_t>(8193 * 3)};
    EXPECT_EQ(decoding_error(encode_png(wide)), "a.png: more than 8192 pixels a side");
}

TEST(Jpeg, DecodesBaselineAndProgressive) {
    for (const char *name : {"red_blue.jpg", "red_blue_progressive.jpg"}) {
        const Image image = decode_image(data_file(name), name);
        ASSERT_EQ(image.size, (Size{32, 16}));
        for (int channel = 0; channel < 3; ++channel) {
            // 0.03: what JPEG at quality 95 loses on a flat field (chroma at half resolution, away from the edge).
            EXPECT_NEAR(image.at(3, 8)[channel], (channel == 0 ? 220 : 30) / 255.0, 0.03) << name;
            EXPECT_NEAR(image.at(28, 8)[channel], (channel == 2 ? 220 : 30) / 255.0, 0.03) << name;
        }
        EXPECT_EQ(image.at(3, 8).a, 1);
    }
}

TEST(Jpeg, DecodesGreyTopRowFirst) {
    const Image image = decode_image(data_file("grey.jpg"), "grey.jpg");
    EXPECT_NEAR(image.at(8, 2).g, 200 / 255.0, 0.02); // as above, without chroma
    EXPECT_NEAR(image.at(8, 13).b, 50 / 255.0, 0.02);
}

TEST(Jpeg, RefusesAFileThatEndsEarly) {
    const std::string whole = data_file("red_blue.jpg");
    for (std::size_t length = 3; length + 2 < whole.size(); ++length) { // + 2: the end marker
        EXPECT_TRUE(decoding_error(whole.substr(0, length)).starts_with("a.png: cannot decode the JPEG file ("))
            << length;
    }
}

TEST(Jpeg, SurvivesAnyChangedByte) {
    // Damage to the compressed data may decode to a wrong picture; it must not end the process.
    for (const char *name : {"red_blue.jpg", "red_blue_progressive.jpg", "cmyk.jpg"}) {
        const std::string whole = data_file(name);
        for (std::size_t at = 3; at < whole.size(); ++at) {
            for (const char value : {'\0', '\xff', '\x7f', static_cast<char>(whole[at] ^ 0x10)}) {
                std::string damaged = whole;
                damaged[at] = value;
                decoding_error(damaged);
            }
        }
    }
}

} // namespace
} // namespace sandbox
