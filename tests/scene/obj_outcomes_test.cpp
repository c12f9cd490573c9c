#include "image/error.h"
#include "scene/obj_reader.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace sandbox {
namespace {

/// What comes of a text: the mesh in numbers and its notes, or the message.
std::string outcome(const std::string &text) {
    try {
        std::vector<std::string> notes;
        const Mesh mesh = read_obj(text, "a.obj", notes);
        double area = 0;
        for (const glm::uvec3 &t : mesh.triangles) {
            const glm::dvec3 &p = mesh.positions[t.x];
            area += glm::length(glm::cross(mesh.positions[t.y] - p, mesh.positions[t.z] - p)) / 2;
        }
        std::string out = fmt::format("{} triangles, {} vertices, area {:g}{}", mesh.triangles.size(),
                                      mesh.positions.size(), area, mesh.uvs.empty() ? "" : ", uv");
        for (const std::string &note : notes) {
            out += "; " + note;
        }
        return out;
    } catch (const InputError &error) {
        return error.what();
    }
}

const std::string cube = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string faces = "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string whole_cube = "12 triangles, 8 vertices, area 24";
const std::string of_no_use = "a normal that is of no use (";

std::string with(std::string text, const std::string &old, const std::string &now) {
    for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += now.size()) {
        text.replace(at, old.size(), now);
    }
    return text;
}

TEST(ObjOutcomes, AreTheseForEveryWayOfWritingAFile) {
    const struct {
        const char *what;
        std::string text, expected;
    } cases[]{
        {"plain", cube + faces, whole_cube},
        {"mark before v", "\xef\xbb\xbf" + cube + faces, whole_cube},
        {"mark before a comment", "\xef\xbb\xbf# x\n" + cube + faces, whole_cube},
        {"CR LF", with(cube + faces, "\n", "\r\n"), whole_cube},
        {"CR", with(cube + faces, "\n", "\r"), whole_cube},
        {"continued faces", cube + with(faces, " 7", " \\\n 7"), whole_cube},
        {"continued with CR LF", with(cube + with(faces, " 7", " \\\n 7"), "\n", "\r\n"), whole_cube},
        {"no end of the last line", cube + faces.substr(0, faces.size() - 1), whole_cube},
        {"tabs", with(cube + faces, " ", "\t"), whole_cube},
        {"faces first", faces + cube, whole_cube},
        {"trailing slashes", cube + with(with(faces, "\n", " \n"), " \n", "//\n"), whole_cube},
        {"one trailing slash", square + "f 1/ 2/ 3/ 4/", "2 triangles, 4 vertices, area 1"},
        {"smoothing off", cube + "s off\n" + faces, "12 triangles, 24 vertices, area 24"},
        {"smoothing 0", cube + "s 0\n" + faces, "12 triangles, 24 vertices, area 24"},
        {"one group", cube + "s 1\n" + faces, whole_cube},
        {"two groups", cube + with(faces, "f", "s 1\nf") + "s 2\nf 1 2 3\n", "13 triangles, 11 vertices, area 26"},
        {"w", with(cube, "1\n", "1 0.5\n") + faces, whole_cube},
        {"two numbers more", with(cube, "1\n", "1 0.5 x\n") + faces, whole_cube},
        {"colours", with(cube, "1\n", "1 0.5 1 0\n") + faces, whole_cube},
        {"colours and more", with(cube, "1\n", "1 0.5 1 0 1 x\n") + faces, whole_cube},
        {"colours that are none", with(cube, "1\n", "1 0.5 nan x\n") + faces,
         whole_cube + "; 8 colours of vertices are not finite, below 0 or above 1e6; they count as white"},
        {"materials", "mtllib none.mtl\n" + cube + with(faces, "f", "usemtl a\nf"),
         whole_cube + "; mtllib is ignored; materials come from the scene"},
        {"no end of a name", square + "f 1 2 3\nusemtl \\", "1 triangles, 3 vertices, area 0.5"},
        {"uv of three", square + "vt 0 0 x\nf 1/1 2/1 3/1", "1 triangles, 3 vertices, area 0.5, uv"},
        {"uv of one", square + "vt 0.5\nf 1/1 2/1 3/1", "1 triangles, 3 vertices, area 0.5, uv"},
        {"uv of some corners", square + "vt 0 0\nf 1/1 2 3", "1 triangles, 3 vertices, area 0.5, uv"},
        {"uv of none", square, "a.obj: expected at least one triangle with an area, got none"},
        {"concave", "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8",
         "6 triangles, 8 vertices, area 7"},
        {"an arrow from its notch", "v 0 1 0\nv 2 -1 0\nv 0 3 0\nv -2 -1 0\nf 1 2 3 4",
         "2 triangles, 4 vertices, area 4"},
        {"an arrow from its tip", "v 0 1 0\nv 2 -1 0\nv 0 3 0\nv -2 -1 0\nf 3 4 1 2",
         "2 triangles, 4 vertices, area 4"},
        {"an arrow from a barb", "v 0 1 0\nv 2 -1 0\nv 0 3 0\nv -2 -1 0\nf 2 3 4 1", "2 triangles, 4 vertices, area 4"},
        {"a corner twice", square + "f 1 1 2 3 4", "2 triangles, 4 vertices, area 1"},
        {"no vn", square + "f 1//1 2//2 3//3",
         "1 triangles, 3 vertices, area 0.5; 3 corners name " + of_no_use +
             "the file has no vn); it is computed instead"},
        {"vn of no number", square + "vn 0 0 1\nvn -nan(ind) 0 0\nf 1//1 2//1 3//2",
         "1 triangles, 3 vertices, area 0.5; 1 corner names " + of_no_use +
             "0, not finite, or index 0); it is computed instead"},
        {"vn beyond the list", square + "vn 0 0 1\nf 1//1 2//2 3//1",
         "a.obj:6: index 2 is out of range; there are 1 vn"},
        {"vt beyond the list", square + "f 1/1 2/1 3/1", "a.obj:5: index 1 is out of range; there are 0 vt"},
        {"v beyond the list", square + "f 1 2 5", "a.obj:5: index 5 is out of range; there are 4 v"},
        {"lines beside faces", square + "l 1 2\nf 1 2 3",
         "1 triangles, 3 vertices, area 0.5; only faces are drawn; left out: 1 line"},
        {"lines only", square + "l 1 2\np 3\n", "a.obj: expected faces (f), got 1 line, 1 point only"},
        {"surfaces only", square + "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 \\\n4 3\nparm u 0 1\nend\n",
         "a.obj: expected faces (f), got 1 free-form surface only"},
        {"UTF-16 LE", std::string("\xff\xfev\0 \0", 6), "a.obj: expected a text in ASCII or UTF-8, got UTF-16"},
        {"UTF-16 BE", std::string("\xfe\xff\0v\0 ", 6), "a.obj: expected a text in ASCII or UTF-8, got UTF-16"},
        {"UTF-16 without a mark", std::string("\0v\0 ", 4), "a.obj: expected a text in ASCII or UTF-8, got UTF-16"},
        {"too far", "v 2000000000 0 0", "a.obj:1: expected a number within 1e+09 of 0, got \"2000000000\""},
        {"no number", "v 0 0 zero", "a.obj:1: expected a number, got \"zero\""},
        {"# in a word", "o a#b\n" + square + "g #\nf 1 2 3 # 4", "1 triangles, 3 vertices, area 0.5"},
        {"two corners", square + "f 1 2", "a.obj:5: expected a face of at least 3 corners, got 2"},
        {"nothing", "", "a.obj: expected at least one triangle with an area, got none"},
        {"no area", square + "f 1 2 1", "a.obj: expected at least one triangle with an area, got none"},
    };
    for (const auto &[what, text, expected] : cases) {
        EXPECT_EQ(outcome(text), expected) << what;
    }
}

} // namespace
} // namespace sandbox
