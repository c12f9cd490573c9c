#include "image/image_file.h"
#include "tools/error_of.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

using namespace std::string_literals;

Image two_rows() {
    Image image({1, 2});
    image.at(0, 0) = {1, 2, 3, 1};     // top
    image.at(0, 1) = {-1, 0.5F, 0, 1}; // bottom
    return image;
}

TEST(Pfm, IsWrittenBottomRowFirstInLittleEndianFloats) {
    const std::string expected = "PF\n1 2\n-1.0\n"s + "\x00\x00\x80\xbf"s + // -1
                                 "\x00\x00\x00\x3f"s +                      // 0.5
                                 "\x00\x00\x00\x00"s +                      // 0
                                 "\x00\x00\x80\x3f"s +                      // 1
                                 "\x00\x00\x00\x40"s +                      // 2
                                 "\x00\x00\x40\x40"s;                       // 3
    EXPECT_EQ(encode_pfm(two_rows()), expected);
}

TEST(Pfm, ReadsBackWhatWasWritten) {
    const Image back = decode_pfm(encode_pfm(two_rows()), "a.pfm");
    EXPECT_EQ(back.size, (Size{1, 2}));
    EXPECT_EQ(back.pixels, two_rows().pixels);
}

TEST(Pfm, ReadsBigEndianAndGrey) {
    EXPECT_EQ(decode_pfm("PF\n1 1\n1.0\n\x3f\x80\x00\x00\x40\x00\x00\x00\x40\x40\x00\x00"s, "a").at(0, 0),
              glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(decode_pfm("Pf\n1 1\n-1\n\x00\x00\x00\x3f"s, "a").at(0, 0), glm::vec4(0.5F, 0.5F, 0.5F, 1));
}

TEST(Pfm, RefusesWhatIsNoPfmAndNamesTheFile) {
    const std::string length = "a.pfm: cannot decode the PFM file (its length does not match its width and height)";
    const std::string header = "a.pfm: cannot decode the PFM file (expected width, height and a scale other than 0)";
    const std::string whole = encode_pfm(two_rows());
    const auto error = [](const std::string &bytes) { return error_of([&] { decode_pfm(bytes, "a.pfm"); }); };
    EXPECT_EQ(error(""), "a.pfm: cannot decode the PFM file (expected it to begin with PF or Pf)");
    EXPECT_EQ(error(whole.substr(0, whole.size() - 1)), length);
    EXPECT_EQ(error(whole + "x"), length);
    EXPECT_EQ(error("PF\n2147483647 2147483647\n-1\n"), length);
    EXPECT_EQ(error("PF\n-1 1\n-1\n"), header);
    EXPECT_EQ(error("PF\n0 1\n-1\n"), header);
    EXPECT_EQ(error("PF\n1x 1\n-1\n"), header);
    EXPECT_EQ(error("PF\n1 1\n0\n"), header);
    EXPECT_EQ(error("PF\n1 1\nnan\n"), header);
    EXPECT_EQ(error("PF\n99999999999999999999 1\n-1\n"), header);
}

} // namespace
} // namespace sandbox
