#include "commands/process.h"

#include <gtest/gtest.h>

/// What `diagnose` refuses before it draws.
namespace sandbox {
namespace {

TEST(DiagnoseCommand, BadPicturesAreRefusedByName) {
    const TemporaryFolder folder;
    folder.write("text.png", "no picture");
    folder.write("empty.pfm", "");
    folder.write("cut.png", "\x89PNG\r\n\x1a\n");
    folder.write("cut.pfm", "PF\n4 4\n-1\n");
    const auto refused = [&](const Arguments &arguments, const std::string &said) {
        Arguments all{"diagnose", "point-light"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const ProcessResult result = run_sandbox(all);
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    refused({folder.file("none.png")}, "none.png");
    refused({folder.file("text.png")}, "text.png: expected a PNG or PFM picture, got another kind of file");
    refused({folder.file("empty.pfm")}, "empty.pfm: expected a PNG or PFM picture, got an empty file");
    refused({folder.file("cut.png")}, "cut.png");
    refused({folder.file("cut.pfm")}, "cut.pfm");
    refused({folder.file("text.png"), "--technique", "per-pixel/fong"}, "--technique: ");
    refused({}, "diagnose: expected either a PICTURE or --own FILE.glsl, got none");
    folder.write("own.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return P; }\n");
    refused({folder.file("text.png"), "--own", folder.file("own.glsl")},
            "diagnose: expected either a PICTURE or --own FILE.glsl, got both");
    refused({folder.file("text.png"), "--size", "9x9"}, "--size: a PICTURE has its own size");
    refused({folder.file("text.png"), "--technique", "per-pixel/own"}, "--technique: ");
    refused({"--own", folder.file("none.glsl")}, "none.glsl': expected a file of GLSL text");
    refused({folder.file("text.png"), "--out", "a.jpg"}, "--out: expected a file name that ends in .png");
}

} // namespace
} // namespace sandbox
