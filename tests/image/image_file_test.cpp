#include "image/image_file.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <sys/stat.h>

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

TEST(WriteFile, ReplacesTheWholeFileAndLeavesNoOther) {
    const TemporaryFolder folder;
    write_file(folder.path() / "a.txt", "the first, longer text");
    write_file(folder.path() / "a.txt", std::string("b\0c", 3));
    EXPECT_EQ(read_file(folder.path() / "a.txt"), std::string("b\0c", 3));
    EXPECT_EQ(folder.names().size(), 1U);
}

TEST(WriteFile, NamesTheFileThatItCannotWrite) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "missing" / "a.txt";
    EXPECT_EQ(error_of([&] { write_file(path, "x"); }),
              path.string() + ": cannot write the file (No such file or directory)");
    EXPECT_NE(error_of([&] { write_file(folder.path(), "x"); }), "no error"); // a folder
    EXPECT_EQ(folder.names().size(), 0U);
}

TEST(WriteFile, WritesDevicesInPlaceAndThroughLinks) {
    write_file("/dev/null", "x");
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
    const TemporaryFolder folder;
    write_file(folder.path() / "a.txt", "x");
    fs::create_symlink(folder.path() / "a.txt", folder.path() / "link.txt");
    write_file(folder.path() / "link.txt", "y");
    EXPECT_EQ(read_file(folder.path() / "a.txt"), "y");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
}

TEST(ReadFile, NamesTheFileThatItCannotRead) {
    EXPECT_EQ(error_of([] { read_file("/no/such.txt"); }),
              "/no/such.txt: cannot read the file (No such file or directory)");
    EXPECT_EQ(error_of([] { read_file("/tmp"); }), "/tmp: cannot read the file (Is a directory)");
}

TEST(ReadFile, ReadsRegularFilesAlone) {
    const TemporaryFolder folder;
    const fs::path pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(error_of([&] { read_file(pipe); }), pipe.string() + ": expected a regular file, got a pipe");
    EXPECT_EQ(error_of([] { read_file("/dev/zero"); }), "/dev/zero: expected a regular file, got a device");
    write_file(folder.path() / "a.txt", "text");
    fs::create_symlink(folder.path() / "a.txt", folder.path() / "link.txt");
    EXPECT_EQ(read_file(folder.path() / "link.txt"), "text");
    EXPECT_FALSE(read_file("/proc/self/status").empty()) << "a regular file of no size";
}

TEST(ReadFile, LooksAtTheSizeFirst) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "large";
    write_file(path, "");
    fs::resize_file(path, std::uintmax_t{1} << 40); // 1 TiB of nothing
    EXPECT_EQ(error_of([&] { read_file(path); }), path.string() + ": the file is larger than 1024 MiB");
    fs::resize_file(path, 1 << 20);
    EXPECT_EQ(read_file(path, 1 << 20).size(), std::size_t{1} << 20);
    fs::resize_file(path, (1 << 20) + 1);
    EXPECT_EQ(error_of([&] { read_file(path, 1 << 20); }), path.string() + ": the file is larger than 1 MiB");
}

} // namespace
} // namespace sandbox
