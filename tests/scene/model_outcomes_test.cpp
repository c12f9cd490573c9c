#include "image/image_file.h"
#include "scene/mesh.h"
#include "scene/model_objects.h"
#include "scene/model_scene.h"
#include "scene/resources.h"
#include "scene/scene_file.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace sandbox {
namespace {

std::string color_text(std::string_view key, const glm::dvec3 &color, const glm::dvec3 &usual) {
    return color == usual ? "" : fmt::format(" {} {:g} {:g} {:g}", key, color.x, color.y, color.z);
}

/// An object of a model in a line: its faces' name, how many triangles, colours, and what its material says.
std::string object_text(const Object &object) {
    const auto &obj = std::get<ObjShape>(object.mesh);
    const Material &m = object.material;
    const Material usual;
    std::string out = fmt::format("{}{}: {}{}{}", object.name, obj.usemtl ? " usemtl \"" + *obj.usemtl + "\"" : "",
                                  obj.mesh->triangles.size(), obj.mesh->colors.empty() ? "" : " coloured",
                                  obj.mesh->uvs.empty() ? "" : " uv");
    out += color_text("Ka", m.ambient, usual.ambient) + color_text("Kd", m.diffuse, usual.diffuse) +
           color_text("Ks", m.specular, usual.specular) + color_text("Ke", m.emission, usual.emission);
    out += m.shininess == usual.shininess ? "" : fmt::format(" Ns {:g}", m.shininess);
    out += m.texture.empty() ? "" : " map " + std::filesystem::path(m.texture).filename().string();
    return out;
}

class ModelOutcomes : public testing::Test {
  protected:
    TemporaryFolder folder_;

    void SetUp() override {
        folder_.write("t.png", encode_png(to_display(Image({1, 1}))));
        folder_.write("t.txt", "no picture");
        std::filesystem::create_directory(folder_.path() / "sub");
        std::filesystem::create_symlink("loop", folder_.path() / "loop"); // there, and nobody may read it
        folder_.write("sub/u.png", encode_png(to_display(Image({1, 1}))));
    }

    /// What comes of a model beside a library "m.mtl": its objects and notes, or the message.
    std::string outcome(const std::string &obj, const std::string &mtl) {
        folder_.write("a.obj", obj);
        std::filesystem::remove(folder_.path() / "m.mtl");
        if (!mtl.empty()) {
            folder_.write("m.mtl", mtl);
        }
        std::string out;
        const std::string message = error_of([&] {
            Object like;
            like.name = "a";
            const ModelObjects model = objects_of_model(folder_.path() / "a.obj", like);
            for (const Object &object : model.objects) {
                out += (out.empty() ? "" : "; ") + object_text(object);
            }
            for (const std::string &note : model.notes) {
                out += "; note " + note;
            }
        });
        return without_folder(message == "no error" ? out : message);
    }

    std::string without_folder(std::string text) const {
        const std::string folder = folder_.path().string();
        for (std::size_t at = 0; (at = text.find(folder)) != std::string::npos;) {
            text.replace(at, folder.size(), "DIR");
        }
        return text;
    }
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\n";
const std::string lib = "mtllib m.mtl\n";
const std::string red_green = "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n";
const std::string missing = "; its materials are as the scene has them";
const std::string left_out = "; note m.mtl: only Ka, Kd, Ks, Ke, Ns and map_Kd are taken; left out: ";

TEST_F(ModelOutcomes, AreTheseForEveryWayOfNamingMaterials) {
    const struct {
        const char *what;
        std::string obj, mtl, expected;
    } cases[]{
        {"no material", square + "f 1 2 3 4", "", "a: 2"},
        {"one for all", lib + square + "usemtl red\nf 1 2 3 4", red_green, "a: 2 Kd 1 0 0"},
        {"two", lib + square + "usemtl red\nf 1 2 3\nusemtl green\nf 1 3 4", red_green,
         "a (red) usemtl \"red\": 1 Kd 1 0 0; a (green) usemtl \"green\": 1 Kd 0 1 0"},
        {"taken up again", lib + square + "usemtl red\nf 1 2 3\nusemtl green\nf 1 3 4\nusemtl red\nf 2 3 4", red_green,
         "a (red) usemtl \"red\": 2 Kd 1 0 0; a (green) usemtl \"green\": 1 Kd 0 1 0"},
        {"faces before any", lib + square + "f 1 2 3\nusemtl green\nf 1 3 4", red_green,
         "a usemtl \"\": 1; a (green) usemtl \"green\": 1 Kd 0 1 0"},
        {"no name ends it", lib + square + "usemtl green\nf 1 3 4\nusemtl\nf 1 2 3", red_green,
         "a usemtl \"\": 1; a (green) usemtl \"green\": 1 Kd 0 1 0"},
        {"library after the faces", square + "usemtl red\nf 1 2 3\n" + lib, red_green, "a: 1 Kd 1 0 0"},
        {"unused", lib + square + "usemtl red\nusemtl green\nf 1 2 3", red_green, "a: 1 Kd 0 1 0"},
        {"flat faces only", lib + square + "usemtl red\nf 1 2 1\nusemtl green\nf 1 2 3", red_green, "a: 1 Kd 0 1 0"},
        {"a name with blanks", lib + square + "usemtl dark  red \nf 1 2 3", "newmtl dark  red\nKd 0.5 0 0\n",
         "a: 1 Kd 0.5 0 0"},
        {"every key", lib + square + "usemtl x\nf 1 2 3",
         "newmtl x\nKa 0.1 0.1 0.1\nKd 0.2 0.2 0.2\nKs 0.3 0.3 0.3\nKe 0.4 0.4 0.4\nNs 5\n",
         "a: 1 Ka 0.1 0.1 0.1 Kd 0.2 0.2 0.2 Ks 0.3 0.3 0.3 Ke 0.4 0.4 0.4 Ns 5"},
        {"transparency", lib + square + "usemtl x\nf 1 2 3", "newmtl x\nd 0.5\nTr 0.5\nillum 2\n",
         "a: 1" + left_out + "d, Tr, illum"},
        {"no library", lib + square + "usemtl red\nf 1 2 3", "",
         "a: 1; note mtllib m.mtl: no such file in DIR" + missing +
             "; note usemtl red: no library of it has this material; it is as the scene has it"},
        {"no such material", lib + square + "usemtl blue\nf 1 2 3", red_green,
         "a: 1; note usemtl blue: no library of it has this material; it is as the scene has it"},
        {"no usemtl", lib + square + "f 1 2 3", red_green, "a: 1"},
        {"two libraries in a line", "mtllib none.mtl m.mtl\n" + square + "usemtl red\nf 1 2 3", red_green,
         "a: 1 Kd 1 0 0; note mtllib none.mtl: no such file in DIR" + missing},
        {"two lines", lib + "mtllib other things.mtl\n" + square + "usemtl red\nf 1 2 3", red_green,
         "a: 1 Kd 1 0 0; note mtllib other things.mtl: no such file in DIR" + missing},
        {"a library that is a folder", "mtllib sub\n" + square + "usemtl red\nf 1 2 3", "",
         "a: 1; note mtllib sub: DIR/sub: cannot read the file (Is a directory)" + missing +
             "; note usemtl red: no library of it has this material; it is as the scene has it"},
        {"a negative colour", lib + square + "usemtl red\nf 1 2 3", "newmtl red\nKd 1 0 -1\n",
         "DIR/m.mtl:2: Kd: expected a number from 0 to 1e+06, got \"-1\""},
        {"too shiny", lib + square + "usemtl red\nf 1 2 3", "newmtl red\nNs 1e8\n",
         "DIR/m.mtl:2: Ns: expected a number from 0 to 1e+07, got \"1e8\""},
        {"a texture", lib + square + "usemtl x\nf 1/1 2/1 3/1", "newmtl x\nmap_Kd t.png\n", "a: 1 uv map t.png"},
        {"its options", lib + square + "usemtl x\nf 1/1 2/1 3/1", "newmtl x\nmap_Kd -s 2 2 2 t.png\n",
         "a: 1 uv map t.png" + left_out + "map_Kd -s"},
        {"the other slash", lib + square + "usemtl x\nf 1/1 2/1 3/1", "newmtl x\nmap_Kd sub\\u.png\n",
         "a: 1 uv map u.png"},
        {"a texture without vt", lib + square + "usemtl x\nf 1 2 3", "newmtl x\nmap_Kd t.png\n",
         "a: 1; note usemtl x: its faces have no texture coordinates (vt); drawn without its texture"},
        {"no such texture", lib + square + "usemtl x\nf 1/1 2/1 3/1", "newmtl x\nKd 0 0 1\nmap_Kd none.png\n",
         "a: 1 uv Kd 0 0 1; note m.mtl: x: map_Kd none.png: no such file in DIR; drawn without it"},
        {"another kind of file", lib + square + "usemtl x\nf 1/1 2/1 3/1", "newmtl x\nmap_Kd t.txt\n",
         "a: 1 uv; note m.mtl: x: map_Kd t.txt: neither a PNG nor a JPEG; drawn without it"},
        {"a library that may not be read", "mtllib loop\n" + square + "usemtl red\nf 1 2 3", "",
         "a: 1; note mtllib loop: DIR/loop: cannot read the file (Too many levels of symbolic links)" + missing +
             "; note usemtl red: no library of it has this material; it is as the scene has it"},
        {"a texture that may not be read", lib + square + "usemtl x\nf 1/1 2/1 3/1", "newmtl x\nmap_Kd loop\n",
         "a: 1 uv; note m.mtl: x: map_Kd loop: DIR/loop: cannot read the file (Too many levels of symbolic links); "
         "drawn "
         "without it"},
        {"a mark and CR LF", lib + square + "usemtl x\r\nf 1 2 3", "\xef\xbb\xbfnewmtl x\r\nKd 0 0 1\r\n",
         "a: 1 Kd 0 0 1"},
        {"UTF-16", lib + square + "usemtl x\nf 1 2 3", std::string("\xff\xfen\0", 4),
         "DIR/m.mtl: expected a text in ASCII or UTF-8, got UTF-16"},
        {"vertex colours", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3", "", "a: 1 coloured"},
        {"colours and a material", lib + "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nusemtl red\nf 1 2 3", red_green,
         "a: 1 coloured Kd 1 0 0"},
        {"a colour that is none", "v 0 0 0 nan nan nan\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3", "",
         "a: 1 coloured; note 1 colour of a vertex is not finite, below 0 or above 1e6; it counts as white"},
        {"w is no colour", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3", "", "a: 1"},
        {"colours of some", "v 0 0 0\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3", "", "a: 1 coloured"},
    };
    for (const auto &[what, obj, mtl, expected] : cases) {
        EXPECT_EQ(outcome(obj, mtl), expected) << what;
    }
}

/// What a vertex's colour is, and white where it has none or none of use.
TEST_F(ModelOutcomes, ColoursAreThoseOfTheirVertices) {
    folder_.write("a.obj", "v 0 0 0\nv 1 0 0 0.25 0.5 2\nv 0 1 0 -1 0 0\nv 0 0 1 1 0 inf 1\nv 1 1 1 1 0 0 0.5\n"
                           "f 1 2 3\nf 1 4 5\n");
    const ModelObjects model = objects_of_model(folder_.path() / "a.obj", {});
    const Mesh &mesh = *std::get<ObjShape>(model.objects.at(0).mesh).mesh;
    const std::vector<glm::dvec3> expected{{1, 1, 1}, {0.25, 0.5, 2}, {1, 1, 1}, {1, 1, 1}, {1, 0, 0}};
    EXPECT_EQ(mesh.colors, expected);
    EXPECT_EQ(model.notes.at(0), "2 colours of vertices are not finite, below 0 or above 1e6; they count as white");
}

/// Where materials meet nothing changes: one smooth surface, and closed as a whole.
TEST_F(ModelOutcomes, PartsKeepTheNormalsAndTheClosednessOfTheWhole) {
    const std::string cube = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
    folder_.write("m.mtl", red_green);
    folder_.write("a.obj", lib + cube +
                               "usemtl red\nf 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nusemtl green\nf 1 5 8 4\n"
                               "f 8 7 3 4\nf 1 2 6 5\n");
    const Scene scene = scene_of_model(folder_.path() / "a.obj", 1);
    ASSERT_EQ(scene.objects.size(), 2U);
    for (const Object &object : scene.objects) {
        EXPECT_FALSE(object.two_sided);
        const Mesh &mesh = *std::get<ObjShape>(object.mesh).mesh;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            for (int c = 0; c < 3; ++c) { // three equal squares meet at each corner
                EXPECT_NEAR(mesh.normals[i][c], mesh.positions[i][c] / std::sqrt(3.0), 1e-15);
            }
        }
    }
    EXPECT_EQ(scene.camera.target, glm::dvec3(0));
}

/// A written scene reads back equal, without its library, and has the same meshes.
TEST_F(ModelOutcomes, AWrittenSceneNeedsNoLibrary) {
    folder_.write("m.mtl", red_green + "map_Kd t.png\n");
    folder_.write("a.obj", lib + square + "usemtl red\nf 1 2 3\nusemtl green\nf 1/1 3/1 4/1");
    const Scene scene = scene_of_model(folder_.path() / "a.obj", 1);
    std::filesystem::remove(folder_.path() / "m.mtl");
    const Scene read = parse_scene(scene_text(scene), "a.json", folder_.path());
    EXPECT_EQ(read, scene);
    const auto before = Resources(Assets("assets")).load(scene);
    const auto after = Resources(Assets("assets")).load(read);
    ASSERT_EQ(after.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(before[i].mesh->positions, after[i].mesh->positions);
        EXPECT_EQ(before[i].mesh->triangles, after[i].mesh->triangles);
        EXPECT_EQ(before[i].mesh->normals, after[i].mesh->normals);
    }
}

TEST_F(ModelOutcomes, ASceneTakesTheFilesMaterialsWhereItSaysSo) {
    folder_.write("m.mtl", red_green);
    folder_.write("a.obj", lib + square + "usemtl red\nf 1 2 3\nusemtl green\nf 1 3 4");
    const auto parse = [&](const std::string &keys) {
        return parse_scene(R"({"objects": [{"name": "ball", "mesh": {"shape": "sphere"}}, {"name": "square", )" + keys +
                               "}]}",
                           "a.json", folder_.path());
    };
    const std::string rest = R"(, "transform": {"translate": [1, 2, 3]}, "two_sided": true,
                                "material": {"diffuse": [0, 0, 1], "specular": [0, 0, 0]})";
    const Scene scene = parse(R"("mesh": {"obj": "a.obj"}, "materials": "file")" + rest);
    ASSERT_EQ(scene.objects.size(), 3U);
    EXPECT_EQ(scene.objects[1].name, "square (red)");
    EXPECT_EQ(scene.objects[2].material.diffuse, glm::dvec3(0, 1, 0));
    EXPECT_EQ(scene.objects[2].material.specular, glm::dvec3(0)) << "what the library leaves open";
    EXPECT_EQ(scene.objects[2].transform.translate, glm::dvec3(1, 2, 3));
    EXPECT_TRUE(scene.objects[2].two_sided);
    EXPECT_EQ(parse(scene_text(scene).empty() ? "" : R"("mesh": {"obj": "a.obj"}, "materials": "scene")" + rest)
                  .objects.size(),
              2U);
    EXPECT_EQ(error_of([&] { parse(R"("mesh": {"shape": "box"}, "materials": "file")"); }),
              "a.json: objects[1].materials: \"file\" needs the mesh of an .obj file beside the scene");
    EXPECT_EQ(error_of([&] { parse(R"("mesh": {"obj": "vase.obj"}, "materials": "file")"); }),
              "a.json: objects[1].materials: \"file\" needs the mesh of an .obj file beside the scene");
    EXPECT_EQ(error_of([&] { parse(R"("mesh": {"obj": "a.obj", "usemtl": "red"}, "materials": "file")"); }),
              "a.json: objects[1].materials: expected usemtl or materials \"file\", got both");
    EXPECT_EQ(error_of([&] { parse(R"("mesh": {"obj": "a.obj"}, "materials": "mtl")"); }),
              "a.json: objects[1].materials: expected one of \"scene\", \"file\", got \"mtl\"");
}

/// Access denied is not "no such file".
TEST_F(ModelOutcomes, AFileThatMayNotBeReadIsThere) {
    std::filesystem::create_symlink("loop.obj", folder_.path() / "loop.obj");
    EXPECT_EQ(without_folder(error_of([&] { scene_of_model(folder_.path() / "loop.obj", 1); })),
              "DIR/loop.obj: cannot read the file (Too many levels of symbolic links)");
    EXPECT_EQ(without_folder(error_of([&] { scene_of_model(folder_.path() / "none.obj", 1); })),
              "DIR/none.obj: no such file");
}

/// Read once for the scene and its meshes, which nobody keeps when the scene and its resources are gone.
TEST_F(ModelOutcomes, AModelIsReadOnceAndKeptByNobody) {
    folder_.write("a.obj", square + "f 1 2 3");
    Scene scene = scene_of_model(folder_.path() / "a.obj", 1);
    std::weak_ptr<const Mesh> read = std::get<ObjShape>(scene.objects[0].mesh).mesh;
    std::filesystem::remove(folder_.path() / "a.obj");
    Resources resources(Assets("assets"));
    EXPECT_EQ(resources.load(scene)[0].mesh, read.lock());
    scene = Scene{};
    (void)resources.load(scene);
    (void)resources.load(scene); // forgets meshes of earlier scenes
    EXPECT_TRUE(read.expired());
}

TEST_F(ModelOutcomes, AnObjectMayHaveTheFacesOfOneMaterial) {
    folder_.write("a.obj", square + "f 1 2 3\nusemtl green\nf 1 3 4");
    const auto triangles = [&](const std::string &usemtl) {
        const Scene scene =
            parse_scene(R"({"objects": [{"mesh": {"obj": "a.obj")" + usemtl + "}}]}", "a.json", folder_.path());
        return Resources(Assets("assets")).load(scene)[0].mesh->triangles.size();
    };
    EXPECT_EQ(triangles(""), 2U);
    EXPECT_EQ(triangles(R"(, "usemtl": "green")"), 1U);
    EXPECT_EQ(triangles(R"(, "usemtl": "")"), 1U);
    EXPECT_EQ(without_folder(error_of([&] { triangles(R"(, "usemtl": "red")"); })),
              "objects[0].mesh.obj: DIR/a.obj: no faces under usemtl \"red\"; it has \"\", \"green\"");
}

} // namespace
} // namespace sandbox
