#include "commands/gl_command_test.h"
#include "image/image_file.h"

#include <string>

/// Opened models: their materials, the colours of their vertices, their notes.
namespace sandbox {
namespace {

class ModelCommands : public GlCommandTest {
  protected:
    ProcessResult capture(const std::string &scene, const std::string &picture) {
        return run_sandbox({"capture", folder.file(scene), "--out", folder.file(picture), "--size", "96x72"});
    }
    static std::size_t count(const std::string &text, const std::string &word) {
        std::size_t n = 0;
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
            ++n;
        }
        return n;
    }
};

/// The library is not needed again: a sidecar holds what it said.
TEST_F(ModelCommands, ASidecarOfAModelMakesItsPictureAgain) {
    folder.write("t.png", encode_png(to_display(Image({4, 4}, {0.2F, 0.9F, 0.4F, 1}))));
    folder.write("m.mtl", "newmtl red\nKd 0.9 0.1 0.1\nKs 0 0 0\nd 1\nnewmtl picture\nmap_Kd t.png\n");
    folder.write("a.obj", "mtllib m.mtl\nv -1 -1 0 1 1 0\nv 1 -1 0 0 1 1\nv 1 1 0 1 0 1\nv -1 1 0\nvt 0 0\nvt 1 1\n"
                          "usemtl red\nf 1 2 3\nusemtl picture\nf 1/1 3/2 4/1\nl 1 2\n");
    const ProcessResult first = capture("a.obj", "a.png");
    ASSERT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(count(first.err, "left out: d\n"), 1U) << first.err;
    EXPECT_EQ(count(first.err, "left out: 1 line"), 1U) << first.err;
    EXPECT_EQ(count(first.err, "note: "), 3U) << first.err << "and that it encloses no volume";
    std::filesystem::remove(folder.path() / "m.mtl");
    const ProcessResult again = capture("a.png.json", "b.png");
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(folder.read("a.png"), folder.read("b.png"));
    const Image picture = decode_image(folder.read("a.png"), "a.png");
    EXPECT_GT(picture.at(52, 44).r, 2 * picture.at(52, 44).g) << "red, below the diagonal";
    EXPECT_GT(picture.at(40, 30).g, picture.at(40, 30).r) << "the texture's colour above it";
}

TEST_F(ModelCommands, TheReferenceDrawsItToo) {
    folder.write("a.obj", "v -1 -1 0 0 0 0\nv 1 -1 0 1 0 0\nv 1 1 0 1 1 0\nv -1 1 0 0 1 0.5\nf 1 2 3 4\n");
    for (const char *technique : {"per-pixel/blinn-phong", "flat/lambert", "per-vertex/phong:program=full"}) {
        const ProcessResult compared = run_sandbox({"compare", folder.file("a.obj"), "--left", technique, "--right",
                                                    "reference", "--size", "96x72", "--max-abs", "2e-5"});
        EXPECT_EQ(compared.exit_code, 0) << compared.out << compared.err;
    }
}

} // namespace
} // namespace sandbox
