#include "scene/resources.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"
#include "tools/error_of.h"

#include <cmath>
#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

Object object(const Shape &shape, const std::string &texture = "") {
    Object out;
    out.mesh = shape;
    out.material.texture = texture;
    return out;
}

Scene scene_of(std::vector<Object> objects) {
    Scene scene;
    scene.objects = std::move(objects);
    return scene;
}

TEST(Resources, AreSharedByEqualShapesAndTextures) {
    Resources resources(Assets("assets"));
    const Scene scene = scene_of({object(SphereShape{}, "wood.png"), object(SphereShape{}),
                                  object(SphereShape{2, 32, 64}), object(BoxShape{}, "wood.png")});
    const auto first = resources.load(scene);
    EXPECT_EQ(first[0].mesh, first[1].mesh);
    EXPECT_NE(first[0].mesh, first[2].mesh);
    EXPECT_EQ(first[0].texture, first[3].texture);
    EXPECT_EQ(first[1].texture, nullptr);
    EXPECT_EQ(first[0].texture->size, (Size{1024, 1024}));
    EXPECT_EQ(first[0].mesh->positions, build_mesh(SphereShape{}).positions);
    const auto second = resources.load(scene);
    EXPECT_EQ(first[2].mesh, second[2].mesh) << "kept from one load to the next";
}

TEST(Resources, AreDroppedWhenNoLongerUsed) {
    Resources resources(Assets("assets"));
    const std::weak_ptr<const Mesh> mesh = resources.load(scene_of({object(SphereShape{})}))[0].mesh;
    EXPECT_FALSE(mesh.expired());
    resources.load(scene_of({object(BoxShape{})}));
    EXPECT_TRUE(mesh.expired());
}

TEST(Resources, TakingTurnsBuildsNothingAnewWhileSomeoneHoldsTheMeshes) {
    Resources resources(Assets("assets"));
    const Scene ball = scene_of({object(SphereShape{})});
    const Scene box = scene_of({object(BoxShape{})});
    const auto held = resources.load(ball);
    resources.load(box);
    EXPECT_EQ(resources.load(ball)[0].mesh, held[0].mesh);
    resources.load(box);
    EXPECT_EQ(resources.load(ball)[0].mesh, held[0].mesh);
}

TEST(Resources, AFailedLoadChangesNothing) {
    Resources resources(Assets("assets"));
    const Scene good = scene_of({object(SphereShape{}, "wood.png")});
    const auto before = resources.load(good);
    EXPECT_NE(error_of([&] {
                  resources.load(scene_of({object(BoxShape{}), object(BoxShape{}, "none.png")}));
              }),
              "no error");
    EXPECT_EQ(resources.load(good)[0].mesh, before[0].mesh);
    EXPECT_EQ(resources.load(good)[0].texture, before[0].texture);
}

TEST(Resources, NameWhatIsMissingAndWhatThereIs) {
    Resources resources(Assets("assets"));
    EXPECT_EQ(
        error_of([&] { resources.load(scene_of({object(BoxShape{}, "woood.png")})); }),
        "objects[0].material.texture: woood.png: no such texture; looked for it among the built-in ones (bricks.png, "
        "checker.png, marble.png, tiles.png, wood.png)");
    EXPECT_EQ(error_of([&] { resources.load(scene_of({object(ObjShape{"vaze.obj"})})); }),
              "objects[0].mesh.obj: vaze.obj: no such model; looked for it among the built-in ones "
              "(vase.obj)"); // the stability cases' broken models are
                             // none of them
    EXPECT_EQ(error_of([&] { resources.load(scene_of({object(ObjShape{"/no/such.obj"})})); }),
              "objects[0].mesh.obj: /no/such.obj: cannot read the file (No such file or directory)");
}

/// The folder where bare names of a scene's file were looked for, or of a --set.
TEST(Resources, NameTheFolderThatTheyLookedIn) {
    const auto refusal = [](const Scene &scene) {
        return error_of([&] { Resources(Assets("assets")).load(scene); }).substr(0, 110);
    };
    const Scene scene = parse_scene(R"({"objects": [{"mesh": {"shape": "box"}, "material": {"texture": "none.png"}}]})",
                                    "a.json", "/a/folder");
    EXPECT_EQ(refusal(scene), std::string("objects[0].material.texture: none.png: no such texture; looked for it in "
                                          "/a/folder and among the built-in ones (bricks.png")
                                  .substr(0, 110));
    const std::string here = std::filesystem::current_path().string();
    const Scene set = with_setting(scene, "objects[0].material.texture=nil.png");
    EXPECT_NE(error_of([&] { Resources(Assets("assets")).load(set); }).find("looked for it in " + here + " and among"),
              std::string::npos);
    const Scene other = with_setting(scene, "ambient=[1,1,1]");
    EXPECT_EQ(refusal(other), refusal(scene));
}

TEST(Assets, InsideTheExecutableAreThoseOnDisk) {
    const Assets inside("assets");
    const Assets outside("assets", std::filesystem::path(SOURCE_DIR) / "assets");
    for (const char *folder : {"scenes/", "textures/", "models/", "stability/"}) {
        EXPECT_EQ(inside.list(folder), outside.list(folder));
        EXPECT_FALSE(inside.list(folder).empty());
        for (const std::string &path : inside.list(folder)) {
            EXPECT_EQ(inside.read(path), outside.read(path)) << path;
        }
    }
}

TEST(Assets, KnowNothingElse) {
    EXPECT_FALSE(Assets("assets").read("scenes/none.json"));
    EXPECT_FALSE(Assets("assets", std::filesystem::path(SOURCE_DIR) / "assets").read("scenes"));
    EXPECT_EQ(error_of([] { const Assets missing("assets", "/no/such/folder"); }),
              "--assets /no/such/folder: expected a folder (No such file or directory)");
}

TEST(Resources, RepeatsAreThoseOfAMaterialWithATexture) {
    Resources resources(Assets("assets"));
    Scene scene = scene_of({object(PlaneShape{}, "wood.png"), object(PlaneShape{}, "wood.png"), object(PlaneShape{})});
    scene.objects[1].material.texture_repeat = scene.objects[2].material.texture_repeat = {4, 2};
    const auto loaded = resources.load(scene);
    EXPECT_EQ(loaded[0].mesh, loaded[2].mesh);
    EXPECT_NE(loaded[0].mesh, loaded[1].mesh);
    const auto span = [](const Mesh &mesh) {
        const glm::uvec3 &t = mesh.triangles.front();
        return glm::max(glm::max(mesh.uvs[t.x], mesh.uvs[t.y]), mesh.uvs[t.z]) -
               glm::min(glm::min(mesh.uvs[t.x], mesh.uvs[t.y]), mesh.uvs[t.z]);
    };
    EXPECT_EQ(span(*loaded[1].mesh), glm::dvec2(4, 2) * span(*loaded[0].mesh));
    EXPECT_EQ(resources.load(scene)[1].mesh, loaded[1].mesh) << "kept from one load to the next";
}

/// IEC 61966-2-1, for the same file in the same scene.
TEST(Resources, ATextureIsDecodedWhereItsNumbersAreSrgb) {
    Resources resources(Assets("assets"));
    Scene scene = scene_of({object(BoxShape{}, "wood.png"), object(BoxShape{}, "wood.png")});
    scene.objects[1].material.texture_color_space = ColorSpace::srgb;
    const auto loaded = resources.load(scene);
    ASSERT_NE(loaded[0].texture, loaded[1].texture);
    for (std::size_t i = 0; i < loaded[0].texture->pixels.size(); i += 97) {
        const glm::vec4 &encoded = loaded[0].texture->pixels[i];
        const glm::vec4 &light = loaded[1].texture->pixels[i];
        for (int c = 0; c < 3; ++c) {
            const double expected = std::pow((encoded[c] + 0.055) / 1.055, 2.4);
            EXPECT_NEAR(light[c], encoded[c] > 0.04045F ? expected : encoded[c] / 12.92, 1e-7);
        }
        EXPECT_EQ(light.a, encoded.a);
    }
    EXPECT_EQ(resources.load(scene)[1].texture, loaded[1].texture) << "kept from one load to the next";
}

TEST(Srgb, DecodingUndoesTheDisplaysCurve) {
    Image image({256, 1});
    for (int i = 0; i < 256; ++i) {
        image.at(i, 0) = glm::vec4(static_cast<float>(i) / 255.0F);
    }
    const ByteImage shown = to_display(decoded_srgb(image), Display::srgb);
    for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_EQ(shown.rgb[3 * i], i);
    }
}

} // namespace
} // namespace sandbox
