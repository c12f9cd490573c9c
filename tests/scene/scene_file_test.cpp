#include "scene/scene_file.h"

#include "image/image_file.h"
#include "scene/orbit.h"
#include "scene/resources.h"
#include "tools/error_of.h"

#include <cstdlib>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

const Assets &assets() {
    static const Assets built_in("assets");
    return built_in;
}

struct Folder {
    fs::path path = fs::temp_directory_path() / ("sandbox-scene-file-test-" + std::to_string(std::rand()));
    Folder() { fs::create_directories(path / "sub"); }
    ~Folder() { fs::remove_all(path); }
};

/// A number that uses all of a double's digits.
double digits(std::mt19937 &random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
glm::dvec3 vector(std::mt19937 &random, double low, double high) {
    return {digits(random, low, high), digits(random, low, high), digits(random, low, high)};
}

Camera random_camera(std::mt19937 &random) {
    Camera camera{vector(random, -1e9, 1e9), vector(random, -1, 1),    vector(random, 0.1, 1),
                  digits(random, 1e-9, 179), digits(random, 1e-12, 1), digits(random, 2, 1e15)};
    return random() % 2 == 0 ? camera : with_projection(camera, Projection::orthographic);
}

/// Every key of every table at a value that is not its default.
Scene full_scene(unsigned seed) {
    std::mt19937 random(seed);
    Scene scene{"a \"name\"",
                "two\nlines, \xe5\x85\x89",
                "a source",
                random_camera(random),
                vector(random, 0, 1e6),
                vector(random, 0, 1),
                digits(random, 1e-9, 16),
                {},
                {},
                {},
                {"per-vertex/phong", "flat/lambert", "wipe"},
                {"/a folder"}};
    for (const LightType type : {LightType::directional, LightType::point, LightType::spot}) {
        scene.lights.push_back({type,
                                false,
                                vector(random, 0, 1),
                                digits(random, 0, 1),
                                digits(random, 0, 1e6),
                                digits(random, 0, 1e-300),
                                true,
                                vector(random, -1e9, 1e9),
                                vector(random, -1, 1),
                                {digits(random, 0, 1), digits(random, 0, 1e9), digits(random, 0, 1e-30)},
                                digits(random, 40, 90),
                                digits(random, 0, 40),
                                digits(random, 0, 1e5)});
    }
    scene.lights[0].cutoff_degrees = scene.lights[0].inner_cutoff_degrees = 180;
    const Shape shapes[] = {SphereShape{digits(random, 0, 1e9), 7, 9},
                            BoxShape{vector(random, 0.1, 1), 3},
                            PlaneShape{{digits(random, 0.1, 9), digits(random, 0.1, 9)}, 5},
                            CylinderShape{digits(random, 0.1, 1), digits(random, 0.1, 1), 5, 6, false},
                            TorusShape{digits(random, 0.1, 1), digits(random, 0.1, 1), 5, 6},
                            ObjShape{"/a/b.obj", "my red"}};
    for (const Shape &shape : shapes) {
        Material material{vector(random, 0, 1),
                          vector(random, 0, 1),
                          vector(random, 0, 1),
                          vector(random, 0, 1),
                          digits(random, 0, 1e7),
                          "/a/b.png",
                          false,
                          {},
                          ColorSpace::srgb,
                          {digits(random, 0.1, 9), digits(random, 0.1, 9)}};
        if (scene.objects.size() % 2 == 0) {
            material.texture = "";
            material.checker = Checker{3, {vector(random, 0, 1), vector(random, 0, 1)}};
        }
        scene.objects.push_back({"object " + std::to_string(scene.objects.size()),
                                 shape,
                                 {vector(random, -1e9, 1e9), vector(random, -360, 360), vector(random, -1e15, 1e15)},
                                 material,
                                 true});
    }
    scene.views = {{"left", random_camera(random)}, {"right", Camera{}}};
    return scene;
}

TEST(SceneText, ReadsBackExactly) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Scene scene = full_scene(seed);
        EXPECT_EQ(parse_scene(scene_text(scene), "a.json", "/nowhere"), scene) << seed;
    }
    EXPECT_EQ(parse_scene(scene_text(Scene{}), "a.json", {}), Scene{});
}

TEST(SceneText, LeavesOutWhatIsAtItsDefault) {
    Scene scene;
    EXPECT_EQ(scene_text(scene), "{}\n");
    Light light;
    light.cutoff_degrees = light.inner_cutoff_degrees = 20;
    scene.lights = {light};
    Object object;
    object.material.shininess = 0.1;
    scene.objects = {object};
    EXPECT_EQ(scene_text(scene), R"({
  "lights": [{"type": "point", "position": [0, 0, 0], "cutoff_degrees": 20}],
  "objects": [{"mesh": {"shape": "sphere"}, "material": {"shininess": 0.1}}]
}
)");
}

TEST(SceneText, BreaksLongLines) {
    const std::string text = scene_text(full_scene(1));
    std::size_t start = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; start = end + 1, end = text.find('\n', start)) {
        EXPECT_LE(end - start, 100U) << text.substr(start, end - start);
    }
}

TEST(ScenePaths, BecomeAbsoluteUnlessBuiltIn) {
    const Folder folder;
    write_file(folder.path / "mine.png", "x");
    write_file(folder.path / "sub" / "other.png", "x");
    const auto texture = [&](const std::string &name) {
        const std::string text =
            R"({"objects": [{"mesh": {"shape": "box"}, "material": {"texture": ")" + name + "\"}}]}";
        return parse_scene(text, "a.json", folder.path).objects[0].material.texture;
    };
    EXPECT_EQ(texture("mine.png"), (folder.path / "mine.png").string());
    EXPECT_EQ(texture("sub/other.png"), (folder.path / "sub/other.png").string());
    EXPECT_EQ(texture("sub/../gone.png"), (folder.path / "gone.png").string());
    EXPECT_EQ(texture("wood.png"), "wood.png");
    EXPECT_EQ(texture("/a/b.png"), "/a/b.png");
    EXPECT_EQ(texture(""), "");
    const Scene model = parse_scene(R"({"objects": [{"mesh": {"obj": "models/a.obj"}}]})", "a.json", folder.path);
    EXPECT_EQ(model.objects[0].mesh, Shape(ObjShape{(folder.path / "models/a.obj").string()}));
    const std::string unreadable = std::string(300, 'a') + ".obj"; // taken for one that is there
    EXPECT_EQ(parse_scene(R"({"objects": [{"mesh": {"obj": ")" + unreadable + R"("}}]})", "a.json", folder.path)
                  .objects[0]
                  .mesh,
              Shape(ObjShape{(folder.path / unreadable).string()}));
}

TEST(OpenScene, ReadsFilesSidecarsAndModels) {
    const Folder folder;
    const std::string file = (folder.path / "a.json").string();
    write_file(file, R"({"name": "from a file"})");
    EXPECT_EQ(open_scene(file, assets()).name, "from a file");
    write_file(folder.path / "a.png.json", R"({"techniques": [], "scene": {"name": "from a sidecar"}})");
    EXPECT_EQ(open_scene((folder.path / "a.png.json").string(), assets()).name, "from a sidecar");
    write_file(folder.path / "tri.OBJ", "v 10 0 0\nv 11 0 0\nv 10 1 0\nf 1 2 3\n");
    const Scene model = open_scene((folder.path / "tri.OBJ").string(), assets());
    EXPECT_EQ(model.name, "tri");
    EXPECT_EQ(model.objects.at(0).mesh, Shape(ObjShape{(folder.path / "tri.OBJ").string()}));
    EXPECT_FALSE(model.lights.empty());
    EXPECT_EQ(model.camera.target, glm::dvec3(10.5, 0.5, 0));
    EXPECT_EQ(parse_scene(scene_text(model), "again", {}), model);
}

TEST(OpenScene, SaysWhatIsWrong) {
    const Folder folder;
    const auto error = [](const std::string &name) { return error_of([&] { open_scene(name, assets()); }); };
    EXPECT_EQ(error("three-point-light"),
              "three-point-light: no built-in scene of that name; did you mean \"three-point-lights\"?");
    EXPECT_TRUE(error("x").starts_with("x: no built-in scene of that name; expected one of studio, "));
    EXPECT_EQ(error("no/such.json"), "no/such.json: no such file");
    EXPECT_EQ(error("no/such.obj"), "no/such.obj: no such file");
    // As one that may not be looked at: the system's own reason, not that there is none.
    const std::string unreadable = std::string(300, 'a') + ".json";
    EXPECT_EQ(error(unreadable), unreadable + ": cannot read the file (File name too long)");
    const std::string picture = (folder.path / "a.png").string();
    write_file(picture, "x");
    EXPECT_EQ(error(picture), picture + ": expected a .json or .obj file");
    EXPECT_EQ(error(folder.path.string()), folder.path.string() + ": expected a .json or .obj file");
    const std::string bad = (folder.path / "bad.json").string();
    write_file(bad, R"({"name": 1})");
    EXPECT_EQ(error(bad), bad + ": name: expected a string, got 1");
}

TEST(WithView, ReplacesTheCamera) {
    const Scene scene = full_scene(3);
    EXPECT_EQ(with_view(scene, "right").camera, Camera{});
    EXPECT_EQ(error_of([&] { with_view(scene, "middle"); }),
              "--view middle: no such view of this scene; expected one of left, right");
    EXPECT_EQ(error_of([&] { with_view(scene, "lft"); }),
              "--view lft: no such view of this scene; did you mean \"left\"?");
    EXPECT_EQ(error_of([&] { with_view(Scene{}, "a"); }), "--view a: no such view of this scene; it has none");
}

TEST(BuiltInScenes, ComeInTheOrderTheyAreTaught) {
    const std::vector<std::string> expected{"studio",
                                            "three-point-lights",
                                            "three-point-lights-original",
                                            "three-directional-lights",
                                            "box-1-colour",
                                            "box-2-ambient",
                                            "box-3-diffuse",
                                            "box-4-normal-matrix",
                                            "box-5-specular",
                                            "chequered-sphere",
                                            "directional-light",
                                            "point-light",
                                            "spot-light",
                                            "vase"};
    EXPECT_EQ(builtin_scenes(assets()), expected);
}

TEST(BuiltInScenes, CanBeReadAndLoadedAndReadBack) {
    Resources resources(assets());
    for (const std::string &name : builtin_scenes(assets())) {
        const Scene scene = open_scene(name, assets());
        EXPECT_FALSE(scene.name.empty()) << name;
        EXPECT_FALSE(scene.description.empty()) << name;
        EXPECT_EQ(resources.load(scene).size(), scene.objects.size()) << name;
        EXPECT_EQ(parse_scene(scene_text(scene), name, {}), scene) << name;
        for (const Object &object : scene.objects) {
            EXPECT_FALSE(object.name.empty()) << name;
        }
    }
}

TEST(BuiltInScenes, ReadTheSameFromDisk) {
    const Assets on_disk("assets", fs::path(SOURCE_DIR) / "assets");
    for (const std::string &name : builtin_scenes(assets())) {
        EXPECT_EQ(open_scene(name, on_disk), open_scene(name, assets())) << name;
    }
}

TEST(BuiltInScenes, HoldTheNumbersOfTheLabReport) {
    for (const char *name : {"three-point-lights", "three-point-lights-original"}) {
        const Scene scene = open_scene(name, assets());
        ASSERT_EQ(scene.lights.size(), 3U);
        const glm::dvec3 colors[] = {{0.8, 0, 0}, {0, 0.8, 0}, {0.8, 0.8, 0.8}};
        const glm::dvec3 positions[] = {{0, 0, 3}, {-4, 0, -1.5}, {0, 6, 3}};
        for (std::size_t i = 0; i < 3; ++i) {
            const Light &light = scene.lights[i];
            EXPECT_EQ(light.type, LightType::point);
            EXPECT_EQ(light.color, colors[i]);
            EXPECT_EQ(light.position, positions[i]);
            EXPECT_EQ(light.ambient, 0.2);
            EXPECT_EQ(light.diffuse, 0.8);
            EXPECT_EQ(light.specular, 0.8);
            EXPECT_EQ(light.attenuation, (Attenuation{0.2, 0.1, 0.1}));
        }
        for (const Object &object : scene.objects) {
            EXPECT_EQ(object.material.shininess, name == std::string("three-point-lights") ? 32 : 1);
            EXPECT_FALSE(object.material.texture.empty()) << "all objects share one program";
        }
        EXPECT_NO_THROW(with_view(scene, "from-the-green-light"));
        EXPECT_NO_THROW(with_view(scene, "along-the-reflection"));
    }
}

TEST(BuiltInScenes, HoldTheNumbersOfTheTutorial) {
    const Scene first = open_scene("box-1-colour", assets());
    EXPECT_EQ(first.lights.at(0).color * first.lights[0].ambient * first.objects.at(0).material.ambient,
              glm::dvec3(0.5, 0.5, 0));
    EXPECT_EQ(first.lights[0].diffuse + first.lights[0].specular, 0);
    const Scene last = open_scene("box-5-specular", assets());
    const Light &light = last.lights.at(0);
    EXPECT_EQ(light.position, glm::dvec3(-1.5, -2, -3));
    EXPECT_EQ(light.color, glm::dvec3(1));
    EXPECT_EQ(light.ambient, 0.1);
    EXPECT_EQ(light.diffuse, 1);
    EXPECT_EQ(light.specular, 0.5);
    EXPECT_EQ(last.objects.at(0).material.diffuse, glm::dvec3(1, 0.8, 0.6));
    EXPECT_EQ(last.objects[0].material.shininess, 32);
}

} // namespace
} // namespace sandbox
