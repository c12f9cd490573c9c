#include "capture/pack.h"

#include "capture/sidecar.h"
#include "image/error.h"
#include "scene/scene_file.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

/// Two textures of one name, one of a picture's, a model, and a built-in texture.
class PackTest : public testing::Test {
  protected:
    PackTest() {
        for (const char *name : {"one", "two", "pack"}) {
            fs::create_directory(folder.path() / name);
        }
        folder.write("one/a.png", "the first");
        folder.write("two/A.png", "the second");
        folder.write("two/picture.png", "the third");
        folder.write("two/m.obj", "v 0 0 0\n");
        for (const char *name : {"one/a.png", "two/A.png", "two/picture.png", "one/a.png"}) {
            Object object;
            object.material.texture = folder.file(name);
            scene.objects.push_back(object);
        }
        scene.objects[3].mesh = ObjShape{folder.file("two/m.obj")};
        scene.objects.emplace_back().material.texture = "checker.png";
    }
    [[nodiscard]] Pack pack(const std::optional<Grid> &grid = {}) const {
        return pack_of(scene, options, grid, Assets("assets"), folder.path() / "pack", {"picture.png"});
    }
    TemporaryFolder folder;
    Scene scene;
    PictureOptions options;
};

std::string bytes_of(const Pack &pack, const std::string &name) {
    const auto file = std::ranges::find_if(
        pack.files, [&](const OutputFile &candidate) { return candidate.path.filename() == name; });
    return file == pack.files.end() ? "no file" : file->bytes;
}

TEST_F(PackTest, GivesEachFileANameOfItsOwn) {
    const Pack packed = pack();
    EXPECT_EQ(packed.scene.objects[0].material.texture, "./a.png");
    EXPECT_EQ(packed.scene.objects[1].material.texture, "./A-2.png") << "some disks know no case";
    EXPECT_EQ(packed.scene.objects[2].material.texture, "./picture-2.png");
    EXPECT_EQ(packed.scene.objects[3].material.texture, "./a.png") << "once";
    EXPECT_EQ(packed.scene.objects[3].mesh, Shape(ObjShape{"./m.obj"}));
    EXPECT_EQ(packed.scene.objects[4].material.texture, "checker.png");
    EXPECT_EQ(packed.files.size(), 4U);
    EXPECT_EQ(bytes_of(packed, "a.png"), "the first");
    EXPECT_EQ(bytes_of(packed, "A-2.png"), "the second");
    EXPECT_EQ(bytes_of(packed, "picture-2.png"), "the third");
    EXPECT_EQ(bytes_of(packed, "m.obj"), "v 0 0 0\n");
}

TEST_F(PackTest, IsReadWhereverItIs) {
    options.left = options.right = parse_technique_with(
        OwnShader(folder.file("one/mine.glsl"), "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return N; }\n"),
        "per-pixel/own");
    const Grid grid{{options.left}, {"objects[0].material.texture", {"two/A.png", "checker.png"}}, folder.path()};
    const Pack packed = pack(grid);
    EXPECT_EQ(packed.grid->sweep.values, (std::vector<std::string>{"./A-2.png", "checker.png"}));
    const fs::path in = folder.path() / "pack";
    const std::string text = grid_text(sidecar_text(packed.scene, packed.options, {}, in), *packed.grid, in);
    write_files(packed.files);
    fs::rename(in, folder.path() / "elsewhere");
    const fs::path there = folder.path() / "elsewhere";
    EXPECT_EQ(parse_scene(text, "a", there).objects[1].material.texture, (there / "A-2.png").string());
    EXPECT_EQ(sidecar_options(text, "a", there)->left,
              parse_technique_with(
                  OwnShader((there / "mine.glsl").string(), "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return N; }\n"),
                  "per-pixel/own"));
    const auto read = grid_of(text, "a", there);
    ASSERT_TRUE(read);
    EXPECT_EQ(file_of_value(*read, read->sweep.values[0]), (there / "A-2.png").string());
}

TEST_F(PackTest, SaysWhichFileIsMissing) {
    fs::remove(folder.path() / "two/A.png");
    EXPECT_EQ(error_of([&] { (void)pack(); }),
              folder.file("two/A.png") + ": cannot read the file (No such file or directory)");
}

TEST_F(PackTest, ReplacesNoOtherFiles) {
    const fs::path in = folder.path() / "pack";
    refuse_other_files(in, {"a.png"});
    folder.write("pack/a.png", "x");
    refuse_other_files(in, {"a.png", "b.png"});
    folder.write("pack/mine.txt", "x");
    EXPECT_EQ(error_of([&] {
                  refuse_other_files(in, {"a.png", "b.png"});
              }),
              "'" + in.string() +
                  "' holds other files (mine.txt); expected a new or an empty folder, or one with the same files");
}

TEST_F(PackTest, HoldsTheBuiltInFilesOfAnotherFolderOfAssets) {
    fs::create_directories(folder.path() / "assets/textures");
    folder.write("assets/textures/checker.png", "another");
    const Pack packed =
        pack_of(scene, options, {}, Assets("assets", folder.path() / "assets"), folder.path() / "pack", {});
    EXPECT_EQ(packed.scene.objects[4].material.texture, "./checker.png");
    EXPECT_EQ(bytes_of(packed, "checker.png"), "another");
}

} // namespace
} // namespace sandbox
