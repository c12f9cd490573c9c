#include "image/image_size.h"

#include "image/file_io.h"
#include "image/png.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(ImageSize, IsThatOfTheHeader) {
    EXPECT_EQ(image_size(encode_png(to_display(Image({5, 3})))), (Size{5, 3}));
    for (const char *name : {"grey.jpg", "red_blue.jpg", "red_blue_progressive.jpg", "cmyk.jpg"}) {
        const std::string bytes = read_file(std::string(TEST_DATA_DIR) + "/" + name);
        const auto size = image_size(bytes);
        ASSERT_TRUE(size) << name;
        EXPECT_GT(size->width * size->height, 0) << name;
    }
}

TEST(ImageSize, IsUnknownOfWhatHasNone) {
    EXPECT_FALSE(image_size(""));
    EXPECT_FALSE(image_size("GIF89a"));
    const std::string png = encode_png(to_display(Image({5, 3})));
    const std::string jpeg = read_file(TEST_DATA_DIR "/grey.jpg");
    for (std::size_t length = 0; length < 24; ++length) {
        EXPECT_FALSE(image_size(png.substr(0, length))) << length;
        EXPECT_FALSE(image_size(jpeg.substr(0, length / 2))) << length;
    }
}

} // namespace
} // namespace sandbox
