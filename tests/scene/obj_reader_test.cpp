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
    EXPECT_EQ(error(triangle + "f 1 2 4"), "a.obj:4: index 4 is out of range; there are 3 v so far");
    EXPECT_EQ(error(triangle + "f -4 2 3"), "a.obj:4: index -4 is out of range; there are 3 v so far");
    EXPECT_EQ(error(triangle + "f 1/1 2 3"), "a.obj:4: index 1 is out of range; there are 0 vt so far");
    EXPECT_EQ(error(triangle + "f 1//1 2 3"), "a.obj:4: index 1 is out of range; there are 0 vn so far");
    EXPECT_EQ(error("f 1 2 3\n" + triangle), "a.obj:1: index 1 is out of range; there are 0 v so far");
    EXPECT_EQ(error(triangle + "\nf 1 x 3"), "a.obj:5: expected an index, got \"x\"");
    EXPECT_EQ(error(triangle + "f 1 2/ 3"), "a.obj:4: expected an index, got \"\"");
    EXPECT_EQ(error(triangle + "f 1 2// 3"), "a.obj:4: expected an index, got \"\"");
    EXPECT_EQ(error(triangle + "f 1 2.0 3"), "a.obj:4: expected an index, got \"2.0\"");
    EXPECT_EQ(error(triangle + "f 1 99999999999999999999 3"),
              "a.obj:4: expected an index, got \"99999999999999999999\"");
    EXPECT_EQ(error(with_all + "f 1/1/1/1 2 3"), "a.obj:7: expected v/vt/vn, got \"1/1/1/1\"");
    EXPECT_EQ(error(triangle + "f 1 2"), "a.obj:4: expected a face of at least 3 corners, got 2");
    EXPECT_EQ(error("v 1.0abc 0 0"), "a.obj:1: expected a number, got \"1.0abc\"");
    EXPECT_EQ(error("v nan 0 0"), "a.obj:1: expected a number, got \"nan\"");
    EXPECT_EQ(error("v inf 0 0"), "a.obj:1: expected a number, got \"inf\"");
    EXPECT_EQ(error("v 1e999 0 0"), "a.obj:1: expected a number, got \"1e999\"");
    EXPECT_EQ(error("v 2e9 0 0"), "a.obj:1: expected a number, got \"2e9\"");
    EXPECT_EQ(error("v +-1 0 0"), "a.obj:1: expected a number, got \"+-1\"");
    EXPECT_EQ(error("v 1 2"), "a.obj:1: expected 3 numbers, got 2");
    EXPECT_EQ(error("v 1 2 \\\n3"), "a.obj:1: a line continued with \\ is not supported");
}

TEST(Obj, IgnoresWhatItDoesNotKnow) {
    EXPECT_EQ(read_obj("g x\nusemtl y\nvp 1 2\nl 1 2\n" + triangle + "f 1 2 3", "a.obj").triangles.size(), 1U);
}

} // namespace
} // namespace sandbox
