#include "scene/scene_setting.h"
#include "tools/error_of.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sandbox {
namespace {

Scene two_lights() {
    Scene scene;
    scene.lights.resize(2);
    scene.lights[1].attenuation.linear = 0.1;
    scene.objects.resize(1);
    scene.views = {{"front", Camera{}}};
    return scene;
}

std::string error(const std::string &setting) {
    return error_of([&] { with_setting(two_lights(), setting); });
}

TEST(Setting, ChangesOneValueAndNoOther) {
    Scene expected = two_lights();
    expected.lights[0].diffuse = 0.5;
    EXPECT_EQ(with_setting(two_lights(), "lights[0].diffuse=0.5"), expected);
    expected = two_lights();
    expected.lights[1].attenuation.quadratic = 1e9;
    EXPECT_EQ(with_setting(two_lights(), "lights[1].attenuation.quadratic=1e9"), expected);
    expected = two_lights();
    expected.camera.position.y = -2.5;
    EXPECT_EQ(with_setting(two_lights(), "camera.position[1]=-2.5"), expected);
    expected = two_lights();
    expected.background = {1, 0, 0.5};
    EXPECT_EQ(with_setting(two_lights(), "background=[1, 0, 0.5]"), expected);
    expected = two_lights();
    expected.views[0].camera.far_plane = 7;
    EXPECT_EQ(with_setting(two_lights(), "views[0].camera.far=7"), expected);
}

TEST(Setting, TakesBareWordsAsStrings) {
    EXPECT_EQ(with_setting(two_lights(), "lights[0].type=spot").lights[0].type, LightType::spot);
    EXPECT_EQ(with_setting(two_lights(), "lights[0].type=directional").lights[0].type, LightType::directional);
    EXPECT_EQ(with_setting(two_lights(), "name=A = B").name, "A = B");
    EXPECT_EQ(with_setting(two_lights(), "name=\"12\"").name, "12");
    EXPECT_EQ(with_setting(two_lights(), "lights[0].enabled=false").lights[0].enabled, false);
    EXPECT_EQ(with_setting(two_lights(), "objects[0].material.texture=wood.png").objects[0].material.texture,
              "wood.png");
}

TEST(Setting, TakesAnyTextWhereATextIs) {
    for (const std::string text : {"", "5", "true", "null", "[draft", "{", "a \"b\"", "=", "1e999"}) {
        EXPECT_EQ(with_setting(two_lights(), "name=" + text).name, text);
    }
    EXPECT_EQ(error("name=\"").substr(0, 11), "--set name:") << "which begins JSON";
    EXPECT_EQ(with_setting(two_lights(), "objects[0].material.texture=").objects[0].material.texture, "");
    EXPECT_EQ(error("lights[0].diffuse="), "--set: lights[0].diffuse: expected a number, got \"\"");
}

TEST(Settings, AreJudgedTogether) {
    const std::vector<std::string> above{"camera.position=[0,5,0]", "camera.target=[0,0,0]", "camera.up=[0,0,-1]"};
    EXPECT_EQ(with_settings(two_lights(), above, "--set", "/").camera.up, glm::dvec3(0, 0, -1));
    const std::vector<std::string> far{"camera.near=500", "camera.far=1000"},
        box{"objects[0].mesh.shape=box", "objects[0].mesh.size[0]=3"};
    EXPECT_EQ(with_settings(two_lights(), far, "--set", "/").camera.near_plane, 500);
    EXPECT_EQ(with_settings(two_lights(), box, "--set", "/").objects[0].mesh, Shape(BoxShape{{3, 1, 1}, 1}));
    const std::vector<std::string> wrong{"lights[0].diffuse=-1", "name=a"};
    EXPECT_EQ(error_of([&] { with_settings(two_lights(), wrong, "--set", "/"); }),
              "--set: lights[0].diffuse: expected a number >= 0, got -1");
}

TEST(Setting, MakesWhatIsOptional) {
    EXPECT_EQ(with_setting(two_lights(), "objects[0].material.checker.cells=3").objects[0].material.checker,
              (Checker{.cells = 3}));
    EXPECT_EQ(with_setting(two_lights(), "objects[0].material.checker={}").objects[0].material.checker, Checker{});
    EXPECT_TRUE(with_setting(two_lights(), "lights=[]").lights.empty());
}

TEST(Setting, AnotherShapeBeginsWithItsDefaults) {
    EXPECT_EQ(with_setting(two_lights(), "objects[0].mesh.shape=box").objects[0].mesh, Shape(BoxShape{}));
    EXPECT_EQ(with_setting(two_lights(), "objects[0].mesh.obj=/a/b.obj").objects[0].mesh, Shape(ObjShape{"/a/b.obj"}));
    EXPECT_EQ(with_setting(two_lights(), "objects[0].mesh.rings=5").objects[0].mesh, Shape(SphereShape{1, 5, 64}));
}

TEST(Setting, ADefaultInnerConeFollowsTheOuter) {
    const Scene narrow = with_setting(two_lights(), "lights[0].cutoff_degrees=10");
    EXPECT_EQ(narrow.lights[0].inner_cutoff_degrees, 10);
    const Scene soft = with_setting(two_lights(), "lights[0].inner_cutoff_degrees=20");
    EXPECT_EQ(with_setting(soft, "lights[0].cutoff_degrees=40").lights[0].inner_cutoff_degrees, 20);
}

TEST(Setting, RefusesBadValuesByTheSameRules) {
    EXPECT_EQ(error("lights[1].attenuation.linear=-1"),
              "--set: lights[1].attenuation.linear: expected a number >= 0, got -1");
    EXPECT_EQ(error("lights[0].diffuse=bright"), "--set: lights[0].diffuse: expected a number, got \"bright\"");
    EXPECT_EQ(error("lights[0].diffuse=NaN"), "--set: lights[0].diffuse: expected a number, got \"NaN\"");
    EXPECT_EQ(error("lights[0].difuse=1"),
              "--set: lights[0].difuse: unknown key of this light; did you mean \"diffuse\"?");
    EXPECT_EQ(error("camera.fov=3"), "--set: camera.fov: unknown key of this camera; did you mean \"fov_y_degrees\"?");
    EXPECT_EQ(error("lights[0].inner_cutoff_degrees=31"),
              "--set: lights[0].inner_cutoff_degrees: expected at most cutoff_degrees (30), got 31");
}

TEST(Setting, RefusesPathsThatLeadNowhere) {
    EXPECT_EQ(error("lights[2].diffuse=1"), "--set lights[2].diffuse: index 2 is out of range; there are 2");
    EXPECT_EQ(error("lights[-1].diffuse=1"), "--set lights[-1].diffuse: expected an index such as [0]");
    EXPECT_EQ(error("lights[]=1"), "--set lights[]: expected an index such as [0]");
    EXPECT_EQ(error("lights[0=1"), "--set lights[0: expected an index such as [0]");
    EXPECT_EQ(error("lights[99999999999999999999]=1"),
              "--set lights[99999999999999999999]: expected an index such as [0]");
    EXPECT_EQ(error("lihgts[0].diffuse=1"),
              "--set lihgts[0].diffuse: unknown key \"lihgts\"; did you mean \"lights\"?");
    EXPECT_EQ(error("camera[0]=1"), "--set camera[0]: [0] needs an array, and this is none");
    EXPECT_EQ(error("name.x=1"), "--set name.x: \"x\" needs an object, and this is none");
    EXPECT_EQ(error("lights[0]diffuse=1"), "--set lights[0]diffuse: expected a path such as lights[0].diffuse");
    EXPECT_EQ(error("camera..far=1"), "--set camera..far: expected a path such as lights[0].diffuse");
    EXPECT_EQ(error("=1"), "--set : expected a path such as lights[0].diffuse");
    EXPECT_EQ(error("camera.far"), "--set camera.far: expected PATH=VALUE, such as lights[0].diffuse=0.5");
}

/// A scene with it could be drawn and written, but never read again.
TEST(Setting, RefusesWhatIsNoUtf8) {
    EXPECT_EQ(error("name=stu\x94io"), "--set name: expected text in UTF-8");
    EXPECT_EQ(error("na\xff=1"), "--set na\\xFF: expected text in UTF-8");
}

TEST(Setting, NamesBrokenJson) {
    EXPECT_TRUE(error("background=[1, 2").starts_with("--set background:1:")) << error("background=[1, 2");
}

TEST(Setting, TheOtherProjectionShowsAsMuchAtTheTarget) {
    const Scene flat = with_setting(two_lights(), "camera.projection=orthographic");
    EXPECT_EQ(flat.camera.projection, Projection::orthographic);
    EXPECT_NEAR(flat.camera.height, 2 * std::sqrt(37.0) * std::tan(22.5 * std::numbers::pi / 180), 1e-12);
    EXPECT_EQ(with_setting(flat, "camera.height=3").camera.height, 3);
    EXPECT_NEAR(with_setting(flat, "camera.projection=perspective").camera.fov_y_degrees, 45, 1e-12);
    EXPECT_EQ(with_setting(flat, "camera.projection=orthographic"), flat);
    EXPECT_EQ(error("camera.height=3"),
              "--set: camera.height: expected fov_y_degrees in its place beside projection perspective");
    EXPECT_EQ(error("camera.projection=isometric"),
              "--set: camera.projection: expected one of \"perspective\", \"orthographic\", got \"isometric\"");
    EXPECT_EQ(with_setting(two_lights(), "objects[0].material.texture_color_space=srgb")
                  .objects[0]
                  .material.texture_color_space,
              ColorSpace::srgb);
}

} // namespace
} // namespace sandbox
