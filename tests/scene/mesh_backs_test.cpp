#include "scene/mesh_backs.h"

#include "scene/obj_reader.h"

#include <gtest/gtest.h>
#include <string>

namespace sandbox {
namespace {

const std::string corners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string five_faces = "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\n";
const std::string outward = five_faces + "f 1 2 6 5\n";
const std::string inward = "f 8 7 6 5\nf 3 4 1 2\nf 7 3 2 6\nf 4 8 5 1\nf 4 3 7 8\nf 5 6 2 1\n";

TEST(BacksSeen, AreToldByTheWindingOfEachPart) {
    const std::string beside = "v 9 0 0\nv 9 1 0\nv 9 0 1\nv 10 0 0\n";
    const struct {
        const char *what;
        std::string text;
        BacksSeen seen;
    } cases[]{
        {"a cube", corners + outward, BacksSeen::none},
        {"one of split vertices", corners + "s off\n" + outward, BacksSeen::none},
        {"far from 0", "v 1e8 0 0\nv 100000001 0 0\nv 1e8 1 0\nv 1e8 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4",
         BacksSeen::none},
        {"inside out", corners + inward, BacksSeen::inside_out},
        {"a face missing", corners + five_faces, BacksSeen::open},
        {"a face turned", corners + five_faces + "f 5 6 2 1\n", BacksSeen::open},
        {"a sheet", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", BacksSeen::open},
        {"a sheet of two sides", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1", BacksSeen::open},
        {"a small part beside", corners + outward + beside + "f 9 11 10\nf 9 10 12\nf 10 11 12\nf 11 9 12",
         BacksSeen::none},
        {"and turned", corners + outward + beside + "f 9 10 11\nf 9 12 10\nf 10 12 11\nf 11 12 9",
         BacksSeen::inside_out},
    };
    for (const auto &[what, text, seen] : cases) {
        EXPECT_EQ(backs_seen(read_obj(text, "a.obj")), seen) << what;
    }
}

} // namespace
} // namespace sandbox
