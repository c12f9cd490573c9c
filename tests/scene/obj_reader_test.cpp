#include "scene/obj_reader.h"
#include "tools/error_of.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string with_all = triangle + "vt 0 0\nvt 1 0\nvn 0 0 1\n";

std::string error(const std::string &text) {
    return error_of([&] { read_obj(text, "a.obj"); });
}

std::vector<std::string> notes_of(const std::string &text) {
    std::vector<std::string> notes;
    read_obj(text, "a.obj", notes);
    return notes;
}

TEST(Obj, ReadsPositionsUvsNormalsAndFaces) {
    const Mesh mesh = read_obj(with_all + "# a comment\no name\ns off\nf 1/1/1 2/2/1 3/1/1 # more\r\n", "a.obj");
    ASSERT_EQ(mesh.positions.size(), 3U);
    EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0));
    EXPECT_EQ(mesh.uvs[1], glm::dvec2(1, 0));
    EXPECT_EQ(mesh.normals[2], glm::dvec3(0, 0, 1));
    EXPECT_EQ(mesh.triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
}

TEST(Obj, ReadsEveryFormOfACorner) {
    for (const char *face : {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/1/1", "f -3 -2 -1",
                             "f -3/-2/-1 2/2/1 3//1", "  f\t1   2 3  "}) {
        const Mesh mesh = read_obj(with_all + face, "a.obj");
        EXPECT_EQ(mesh.triangles.size(), 1U) << face;
        EXPECT_EQ(mesh.normals[0], glm::dvec3(0, 0, 1)) << face;
    }
    EXPECT_TRUE(read_obj(with_all + "f 1 2 3", "a.obj").uvs.empty());
}

TEST(Obj, ReadsNumbersInEveryNotation) {
    const Mesh mesh = read_obj("v +0.5 -.5 5e-1\nv 1 0 0 1.0\nv 0 1 0 0.1 0.2 0.3\nf 1 2 3", "a.obj");
    EXPECT_EQ(mesh.positions[0], glm::dvec3(0.5, -0.5, 0.5));
    EXPECT_EQ(read_obj("v 1e-400 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "a.obj").positions[0], glm::dvec3(0));
}

TEST(Obj, SplitsPolygonsAsAFanFromTheFirstVertex) {
    const Mesh mesh = read_obj("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 2 3 4 5 1", "a.obj");
    const std::vector<glm::uvec3> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    EXPECT_EQ(mesh.triangles, fan);
    EXPECT_EQ(mesh.positions[0], glm::dvec3(1, 0, 0));
}

TEST(Obj, MakesNormalsUnitWhateverTheirLength) {
    for (const char *normal : {"vn 0 0 1e-30", "vn 0 0 1e20", "vn 0 0 1e-200", "vn 0 0 1e200", "vn 0 0 7"}) {
        const Mesh mesh = read_obj(triangle + normal + "\nf 1//1 2//1 3//1", "a.obj");
        EXPECT_EQ(mesh.normals[0], glm::dvec3(0, 0, 1)) << normal;
    }
    const Mesh slanted = read_obj(triangle + "vn 1e20 1e20 0\nf 1//1 2//1 3//1", "a.obj");
    EXPECT_NEAR(glm::length(slanted.normals[0]), 1, 1e-15);
}

TEST(Obj, ReplacesAZeroNormalByTheComputedOne) {
    const Mesh mesh = read_obj(triangle + "vn 0 0 0\nf 1//1 2//1 3//1", "a.obj");
    EXPECT_EQ(mesh.normals[0], glm::dvec3(0, 0, 1));
}

TEST(Obj, WeighsMissingNormalsByArea) {
    // Two triangles share the edge 1-2: one in z = 0 with area 1/2, one in y = 0 with area 1.
    const Mesh mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 2 3\nf 2 1 4", "a.obj");
    // Area vectors (0, 0, 1) and (0, 2, 0): face 2 is (1,0,0) (0,0,0) (0,0,2), (-1,0,0) x (-1,0,2) = (0, 2, 0).
    const double length = std::sqrt(5.0);
    EXPECT_NEAR(mesh.normals[0].y, 2 / length, 1e-15);
    EXPECT_NEAR(mesh.normals[0].z, 1 / length, 1e-15);
    EXPECT_EQ(mesh.normals[2], glm::dvec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[3], glm::dvec3(0, 1, 0));
}

TEST(Obj, GivesANormalWhereFacesCancel) {
    const Mesh mesh = read_obj(triangle + "f 1 2 3\nf 3 2 1", "a.obj");
    for (const glm::dvec3 &normal : mesh.normals) {
        EXPECT_EQ(normal, glm::dvec3(0, 0, 1)); // the first face's
    }
}

TEST(Obj, DropsTrianglesWithoutArea) {
    const Mesh mesh = read_obj(triangle + "f 1 1 2\nf 1 2 3\nf 1 2 2", "a.obj");
    EXPECT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.positions.size(), 3U);
    EXPECT_EQ(error(triangle + "f 1 1 2"), "a.obj: expected at least one triangle with an area, got none");
    EXPECT_EQ(error(""), "a.obj: expected at least one triangle with an area, got none");
}

/// As a reader without guards has them: kept for the textbook's pictures where float32 cannot make them unit.
TEST(Obj, KeepsTheFilesOwnNormalsWhereTheyWereMended) {
    const Mesh tiny = read_obj(triangle + "vn 0 0 1e-30\nf 1//1 2//1 3//1", "a.obj");
    ASSERT_EQ(tiny.file_normals.size(), tiny.positions.size());
    EXPECT_EQ(tiny.file_normals[0], glm::vec3(0, 0, 1e-30F));
    EXPECT_EQ(read_obj(triangle + "vn 0 0 0\nf 1//1 2//1 3//1", "a.obj").file_normals[2], glm::vec3(0));
    EXPECT_TRUE(read_obj(triangle + "vn 0 0 7\nf 1//1 2//1 3//1", "a.obj").file_normals.empty()) << "only not unit";
    // A triangle without area has no normal: its corners 1 and 2 get what normalize(0) gives.
    const Mesh degenerate = read_obj(triangle + "f 1 1 2\nf 1 2 3", "a.obj");
    ASSERT_EQ(degenerate.file_normals.size(), 3U);
    EXPECT_TRUE(std::isnan(degenerate.file_normals[0].z));
    EXPECT_TRUE(std::isnan(degenerate.file_normals[1].z));
    EXPECT_EQ(degenerate.file_normals[2], glm::vec3(0, 0, 1));
}

TEST(Obj, RefusesWhatItCannotReadWithTheLine) {
    EXPECT_EQ(error(triangle + "f 0 1 2"), "a.obj:4: index 0 is out of range; there are 3 v so far");
    EXPECT_EQ(error(triangle + "f 1 2 4"), "a.obj:4: index 4 is out of range; there are 3 v");
    EXPECT_EQ(error(triangle + "f 1 2 4294967295"), "a.obj:4: index 4294967295 is out of range; there are 3 v so far");
    EXPECT_EQ(error(triangle + "f -4 2 3"), "a.obj:4: index -4 is out of range; there are 3 v so far");
    EXPECT_EQ(error(triangle + "f 1/1 2 3"), "a.obj:4: index 1 is out of range; there are 0 vt");
    EXPECT_EQ(error(triangle + "vn 0 0 1\nf 1//2 2 3"), "a.obj:5: index 2 is out of range; there are 1 vn");
    EXPECT_EQ(error(triangle + "vn 0 0 1\nf 1//-2 2 3"), "a.obj:5: index -2 is out of range; there are 1 vn so far");
    EXPECT_EQ(error(with_all + "f 1/0 2 3"), "a.obj:7: index 0 is out of range; there are 2 vt so far");
    EXPECT_EQ(error("f -1 2 3\n" + triangle), "a.obj:1: index -1 is out of range; there are 0 v so far");
    EXPECT_EQ(error(triangle + "\nf 1 x 3"), "a.obj:5: expected an index, got \"x\"");
    EXPECT_EQ(error(triangle + "f 1 / 3"), "a.obj:4: expected an index, got \"\"");
    EXPECT_EQ(error(triangle + "f 1 2.0 3"), "a.obj:4: expected an index, got \"2.0\"");
    EXPECT_EQ(error(triangle + "f 1 99999999999999999999 3"),
              "a.obj:4: expected an index, got \"99999999999999999999\"");
    EXPECT_EQ(error(with_all + "f 1/1/1/1 2 3"), "a.obj:7: expected v/vt/vn, got \"1/1/1/1\"");
    EXPECT_EQ(error(triangle + "f 1 2"), "a.obj:4: expected a face of at least 3 corners, got 2");
    EXPECT_EQ(error("v 1.0abc 0 0"), "a.obj:1: expected a number, got \"1.0abc\"");
    EXPECT_EQ(error("v nan 0 0"), "a.obj:1: expected a number, got \"nan\"");
    EXPECT_EQ(error("v inf 0 0"), "a.obj:1: expected a number, got \"inf\"");
    EXPECT_EQ(error("v 1e999 0 0"), "a.obj:1: expected a number within 1e+09 of 0, got \"1e999\"");
    EXPECT_EQ(error("v 2e9 0 0"), "a.obj:1: expected a number within 1e+09 of 0, got \"2e9\"");
    EXPECT_EQ(error("v +-1 0 0"), "a.obj:1: expected a number, got \"+-1\"");
    EXPECT_EQ(error("v 1 2"), "a.obj:1: expected 3 numbers, got 2");
    EXPECT_EQ(error("vn 0 x 0"), "a.obj:1: expected a number, got \"x\"");
    EXPECT_EQ(error("\xff\xfev\0 \0"), "a.obj: expected a text in ASCII or UTF-8, got UTF-16");
    EXPECT_EQ(error(std::string("v\0 \0"
                                "1\0",
                                6)),
              "a.obj: expected a text in ASCII or UTF-8, got UTF-16");
    EXPECT_EQ(error(triangle + "l 1 2\nl 2 3\np 1"), "a.obj: expected faces (f), got 2 lines, 1 point only");
    EXPECT_EQ(error(triangle + "surf 0 1 0 1 1 2 3"), "a.obj: expected faces (f), got 1 free-form surface only");
}

TEST(Obj, IgnoresWhatItDoesNotKnow) {
    EXPECT_EQ(read_obj("g x\nusemtl y\nvp 1 2\nl 1 2\n" + triangle + "f 1 2 3", "a.obj").triangles.size(), 1U);
}

TEST(Obj, ReadsTheSameMeshFromEveryWayOfWritingItsLines) {
    const Mesh plain = read_obj(triangle + "f 1 2 3", "a.obj");
    for (const std::string text :
         {"\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
          "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", "v 0 0 0\rv 1 0 0\r\nv 0 1 0\n\rf 1 2 3",
          "v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 \\\r\n 2 \\ \r\n 3", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 \\",
          "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2// 3/\n",
          "# a folder\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "v 0 0 0 nan x\nv 1 0 0 1e99\nv 0 1 0\nf 1 2 3\n"}) {
        const Mesh mesh = read_obj(text, "a.obj");
        EXPECT_EQ(mesh.positions, plain.positions) << text;
        EXPECT_EQ(mesh.normals, plain.normals) << text;
        EXPECT_EQ(mesh.triangles, plain.triangles) << text;
        EXPECT_EQ(notes_of(text), std::vector<std::string>{}) << text;
    }
}

TEST(Obj, CountsLinesAsAnEditorDoes) {
    EXPECT_EQ(error("v 0 0 0\rv 1 0 0\r\nv 0 1\\\n 0\nf 1 2 9"), "a.obj:5: index 9 is out of range; there are 3 v");
    EXPECT_EQ(error("\n\n\\\n\\\nv x"), "a.obj:3: expected a number, got \"x\"") << "where the line begins";
}

TEST(Obj, ComputesNormalsThatAreOfNoUseAndSaysSo) {
    const std::string one = "1 corner names a normal that is of no use (0, not finite, or index 0); it is computed "
                            "instead";
    const std::string none = "3 corners name a normal that is of no use (the file has no vn); it is computed instead";
    const struct {
        std::string text, note;
    } cases[]{{"vn 0 0 1\nf 1//0 2//1 3//1", one},
              {"vn 0 0 1\nvn -nan(ind) 0 0\nf 1//2 2//1 3//1", one},
              {"vn 0 0 1\nvn 0 1.#QNAN 0\nf 1//2 2//1 3//1", one},
              {"vn 0 0 1\nvn 0 0 inf\nf 1//2 2//1 3//1", one},
              {"vn 0 0 1\nvn 0 0 0\nf 1//2 2//1 3//1", one},
              {"f 1//1 2//2 3//3", none},
              {"f 1//-1 2//-1 3//-1", none}};
    for (const auto &[text, note] : cases) {
        const Mesh mesh = read_obj(triangle + text, "a.obj");
        EXPECT_EQ(notes_of(triangle + text), std::vector{note}) << text;
        for (const glm::dvec3 &normal : mesh.normals) {
            EXPECT_EQ(normal, glm::dvec3(0, 0, 1)) << text;
        }
    }
    EXPECT_TRUE(notes_of(triangle + "vn nan 0 0\nf 1 2 3").empty()) << "no corner names it";
}

TEST(Obj, SaysOnceWhatItLeavesOut) {
    const auto notes = notes_of("mtllib a.mtl\nmtllib b.mtl\nl 1 2\nl 2 3\np 1\n" + triangle + "f 1 2 3");
    EXPECT_EQ(notes, (std::vector<std::string>{"only faces are drawn; left out: 2 lines, 1 point",
                                               "mtllib is ignored; materials come from the scene"}));
}

// A cube from -1 to 1: its corners, and its faces each from its first corner.
const std::string cube_corners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string cube_faces = "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";
const std::string cube_faces_turned = "f 6 7 8 5\nf 1 4 3 2\nf 2 3 7 6\nf 5 8 4 1\nf 7 3 4 8\nf 2 6 5 1\n";

TEST(Obj, SmoothsACubeAlongItsDiagonalsHoweverItsFacesAreSplit) {
    for (const std::string &faces : {cube_faces, cube_faces_turned}) {
        const Mesh mesh = read_obj(cube_corners + faces, "a.obj");
        ASSERT_EQ(mesh.positions.size(), 8U);
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_NEAR(glm::distance(mesh.normals[i], mesh.positions[i] / std::sqrt(3.0)), 0,
                        1e-15); // three equal faces
        }
    }
}

TEST(Obj, GivesEveryFaceItsOwnNormalWhereSmoothingIsOff) {
    for (const char *off : {"s off\n", "s 0\n", "s\n", "s 1\ns off\n"}) {
        const Mesh mesh = read_obj(cube_corners + off + cube_faces, "a.obj");
        ASSERT_EQ(mesh.positions.size(), 24U) << off;
        const std::vector<glm::dvec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
        for (std::size_t i = 0; i < 24; ++i) {
            EXPECT_EQ(mesh.normals[i], normals[i / 4]) << off;
        }
    }
}

/// Front and right face of the cube share an edge: in one group its normals are between theirs, in two each its own.
TEST(Obj, SmoothsWithinAGroupOnly) {
    const auto normals = [](const std::string &text) { return read_obj(cube_corners + text, "a.obj").normals; };
    const std::vector<glm::dvec3> one = normals("s 1\nf 5 6 7 8\nf 6 2 3 7");
    ASSERT_EQ(one.size(), 6U);
    EXPECT_NEAR(glm::distance(one[1], glm::dvec3(1, 0, 1) / std::sqrt(2.0)), 0, 1e-15);
    const std::vector<glm::dvec3> two = normals("s 1\nf 5 6 7 8\ns 2\nf 6 2 3 7");
    ASSERT_EQ(two.size(), 8U);
    EXPECT_EQ(two[1], glm::dvec3(0, 0, 1));
    EXPECT_EQ(two[4], glm::dvec3(1, 0, 0));
    EXPECT_EQ(normals("f 5 6 7 8\ns 2\nf 6 2 3 7").size(), 8U) << "before any s is a group of its own";
    EXPECT_EQ(normals("s 1\nf 5 6 7 8\ns off\ns 1\nf 6 2 3 7").size(), 6U) << "a group may be gone back to";
}

TEST(Obj, SplitsConcaveFacesAndGivesThemTheirOwnNormal) {
    const Mesh u =
        read_obj("v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8", "a.obj");
    double area = 0;
    for (const glm::uvec3 &t : u.triangles) {
        area += glm::cross(u.positions[t.y] - u.positions[t.x], u.positions[t.z] - u.positions[t.x]).z / 2;
    }
    EXPECT_EQ(area, 7) << "whole numbers: exact";
    EXPECT_EQ(u.against_normals, 0U) << "no triangle outside the outline, which would run the other way";
    for (const glm::dvec3 &normal : u.normals) {
        EXPECT_EQ(normal, glm::dvec3(0, 0, 1));
    }
}

} // namespace
} // namespace sandbox
