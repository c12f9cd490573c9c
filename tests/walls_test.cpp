#include "tools/source_text.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>

/// The walls of the house: which room may include which, which library lives where, and how long a file may be.
/// The rules are tables; the cases at the end hand them broken sources, so that each wall is seen to stand.
namespace sandbox {
namespace {

using Names = std::set<std::string, std::less<>>;

/// A room and the rooms below it. scene uses image, never the other way; reference and render never meet; measure and
/// capture are handed pictures, so they stand above render without seeing it.
const std::map<std::string, Names, std::less<>> rooms_below = {
    {"image", {}},
    {"scene", {"image"}},
    {"shading", {"scene", "image"}},
    {"words", {"image", "scene", "shading"}},
    {"certificate", {"scene", "image", "shading"}},
    {"reference", {"scene", "image", "shading", "certificate"}},
    {"render", {"scene", "image", "shading", "certificate"}},
    {"measure", {"words", "scene", "image", "shading", "certificate", "reference"}},
    {"teach", {"words", "scene", "image", "shading", "certificate", "reference", "measure"}},
    {"capture", {"words", "scene", "image", "shading", "certificate", "reference", "measure", "teach"}},
    {"ui", {"words", "scene", "image", "shading", "certificate", "reference", "render", "measure", "teach", "capture"}},
    {"commands",
     {"words", "scene", "image", "shading", "certificate", "reference", "render", "measure", "teach", "capture", "ui"}},
    {"main.cpp",
     {"scene", "image", "shading", "certificate", "reference", "render", "measure", "capture", "ui", "commands"}},
};

/// The rooms inside a large room, and those that each of them may include. What stands in the large room itself sees
/// all of its inner rooms and is seen by none of them.
const std::map<std::string, Names, std::less<>> inner_rooms_below = {
    {"measure/metrics", {}},
    {"measure/work_precision", {"measure/metrics"}},
    {"measure/stability", {"measure/metrics"}},
    {"measure/diagnosis", {"measure/metrics"}},
    {"measure/report", {"measure/metrics", "measure/work_precision", "measure/stability"}},
    {"teach/files", {}},
    {"teach/marking", {"teach/files"}},
    {"ui/session", {}},
    {"ui/widgets", {"ui/session"}},
    {"ui/script", {}},
    {"ui/views", {"ui/session", "ui/widgets"}},
    {"ui/jobs", {"ui/session", "ui/widgets"}},
    {"ui/panels", {"ui/session", "ui/widgets", "ui/views", "ui/jobs"}},
    {"ui/tabs", {"ui/session", "ui/widgets", "ui/views", "ui/jobs"}},
};

struct Library {
    const char *header; ///< a regular expression on the name between the brackets
    Names rooms;        ///< that may include it; empty: all
};
/// A header of no library here and not of C++'s own is refused: a new library needs an owner first.
const std::vector<Library> libraries = {
    {"[a-z_]+", {}}, // C++'s own
    {"glm/.*", {}},
    {"fmt/.*", {}},
    {"(unistd|fcntl|malloc|poll|termios|spawn)\\.h|sys/.*", {}},
    {"glad/.*|GLES3/.*|EGL/.*|dlfcn\\.h", {"render"}},
    {"GLFW/.*", {"render", "ui"}},
    {"emscripten.*", {"image", "render", "ui"}},
    {"imstb_truetype\\.h", {"image"}},
    {"imgui.*|backends/imgui.*", {"ui"}},
    {"spng\\.h|zlib\\.h|jpeglib\\.h|jerror\\.h", {"image"}},
    {"CLI/.*", {"main.cpp", "commands"}},
    {"nlohmann/.*", {"words", "scene", "measure", "teach", "capture", "ui", "commands"}},
};

const Names rooms_without_opengl = {"words",   "scene", "image",   "shading",  "certificate", "reference",
                                    "measure", "teach", "capture", "commands", "main.cpp"};
constexpr std::size_t longest_file = 450;

std::string room_of(const std::string &path) { return path.substr(0, path.find('/')); }
/// "ui/tabs" of "ui/tabs/a.cpp"; "ui" of "ui/a.cpp".
std::string inner_room_of(const std::string &path) { return path.substr(0, path.rfind('/')); }
bool is_header(const std::string &path) { return path.ends_with(".h"); }

/// What is wrong with one file of sandbox/ (`path` below it), as sentences.
std::vector<std::string> broken_walls(const std::string &path, const std::string &text) {
    std::vector<std::string> broken;
    const auto complain = [&](const std::string &what) { broken.push_back(path + ": " + what); };
    const auto room = room_of(path);
    const auto below = rooms_below.find(room);
    if (below == rooms_below.end()) {
        complain("'" + room + "' is no room of the house");
        return broken;
    }
    if (std::count(path.begin(), path.end(), '/') > 1 && !inner_rooms_below.contains(inner_room_of(path))) {
        complain("'" + inner_room_of(path) + "' is no inner room of the house");
    }
    for (const auto &name : includes_of(text)) {
        const auto other = room_of(name);
        if (rooms_below.contains(other)) {
            if (other != room && !below->second.contains(other)) {
                complain("may not include " + name);
            }
            const auto inner_below = inner_rooms_below.find(inner_room_of(path));
            const auto inner = inner_room_of(name);
            if (other == room && inner_below != inner_rooms_below.end() && inner != inner_below->first &&
                !inner_below->second.contains(inner)) {
                complain("may not include " + name + ": it stands above " + inner_below->first);
            }
            continue;
        }
        const auto library = std::find_if(libraries.begin(), libraries.end(), [&](const Library &l) {
            return std::regex_match(name, std::regex(l.header));
        });
        if (library == libraries.end()) {
            complain(name + " belongs to no known library");
        } else if (!library->rooms.empty() && !library->rooms.contains(room)) {
            complain(name + " lives in another room");
        } else if (is_header(path) && name.starts_with("nlohmann/") && name != "nlohmann/json_fwd.hpp") {
            complain("JSON stays out of headers");
        }
    }
    if (rooms_without_opengl.contains(room)) {
        const auto code = without_comments_and_strings(text);
        std::smatch found;
        if (std::regex_search(code, found,
                              std::regex("\\b(GL_[A-Z]\\w*|gl[A-Z][a-z]\\w*|GL(uint|int|enum|float))\\b"))) {
            complain("names OpenGL: " + found.str());
        }
    }
    return broken;
}

/// A header that names JSON types is its own room's: no other room may include it.
std::vector<std::string> leaked_json(const std::map<std::string, std::string> &sources) {
    std::vector<std::string> broken;
    for (const auto &[path, text] : sources) {
        for (const auto &name : includes_of(text)) {
            const auto header = sources.find(name);
            if (header == sources.end() || room_of(name) == room_of(path)) {
                continue;
            }
            for (const auto &inner : includes_of(header->second)) {
                if (inner.starts_with("nlohmann/")) {
                    broken.push_back(path + ": " + name + " is private to its room");
                }
            }
        }
    }
    return broken;
}

std::string listed(const std::vector<std::string> &lines) {
    std::string all;
    for (const auto &line : lines) {
        all += line + "\n";
    }
    return all;
}

TEST(Walls, EveryRoomIncludesOnlyRoomsBelowItAndItsOwnLibraries) {
    const auto sources = source_files(SOURCE_DIR "/sandbox", {".cpp", ".h"});
    ASSERT_GT(sources.size(), 30U);
    std::vector<std::string> broken = leaked_json(sources);
    for (const auto &[path, text] : sources) {
        const auto more = broken_walls(path, text);
        broken.insert(broken.end(), more.begin(), more.end());
    }
    EXPECT_TRUE(broken.empty()) << listed(broken);
}

TEST(Walls, FilesStaySmall) {
    std::vector<std::string> broken;
    for (const char *folder : {"sandbox", "shaders", "tests"}) {
        for (const auto &[path, text] :
             source_files(std::string(SOURCE_DIR "/") + folder, {".cpp", ".h", ".glsl", ".sh", ".py"})) {
            const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
            if (lines > longest_file) {
                broken.push_back(std::string(folder) + "/" + path + ": " + std::to_string(lines) + " lines");
            }
        }
    }
    EXPECT_TRUE(broken.empty()) << listed(broken);
}

// Each of these breaks one wall.
TEST(WallsStand, AgainstIncludesOfOtherRooms) {
    const std::vector<std::pair<std::string, std::string>> upward = {
        {"scene/a.cpp", "shading/technique.h"}, {"shading/a.cpp", "render/renderer.h"},
        {"reference/a.h", "render/target.h"},   {"render/a.cpp", "reference/raster.h"},
        {"measure/a.cpp", "render/renderer.h"}, {"capture/a.cpp", "render/target.h"},
        {"measure/a.cpp", "capture/layout.h"},  {"ui/a.cpp", "commands/session.h"},
        {"measure/a.cpp", "teach/claims.h"},    {"teach/a.cpp", "capture/layout.h"},
        {"attic/a.cpp", "scene/scene.h"},
    };
    for (const auto &[path, name] : upward) {
        EXPECT_EQ(broken_walls(path, "#include \"" + name + "\"\n").size(), 1U) << path << " " << name;
    }
    EXPECT_TRUE(broken_walls("commands/a.cpp", "#include \"ui/window.h\"\n#include <vector>\n").empty());
}

TEST(WallsStand, AgainstIncludesOfInnerRooms) {
    const std::vector<std::pair<std::string, std::string>> upward = {
        {"measure/metrics/a.cpp", "measure/report/page.h"},
        {"measure/stability/a.cpp", "measure/work_precision/run.h"},
        {"ui/session/a.cpp", "ui/widgets/widgets.h"},
        {"ui/panels/a.cpp", "ui/tabs/tab_content.h"},
        {"ui/tabs/a.cpp", "ui/window.h"},
        {"ui/attic/a.cpp", "scene/scene.h"},
    };
    for (const auto &[path, name] : upward) {
        EXPECT_EQ(broken_walls(path, "#include \"" + name + "\"\n").size(), 1U) << path << " " << name;
    }
    EXPECT_TRUE(broken_walls("ui/window.cpp", "#include \"ui/tabs/tab_content.h\"\n").empty());
    EXPECT_TRUE(broken_walls("ui/tabs/a.cpp", "#include \"ui/tabs/b.h\"\n").empty());
}

TEST(WallsStand, AgainstLibrariesOfOtherRooms) {
    const std::vector<std::pair<std::string, std::string>> strays = {
        {"ui/a.cpp", "glad/gl.h"},
        {"commands/a.cpp", "GLFW/glfw3.h"},
        {"render/a.cpp", "imgui.h"},
        {"ui/a.cpp", "spng.h"},
        {"scene/a.cpp", "jpeglib.h"},
        {"ui/a.cpp", "CLI/CLI.hpp"},
        {"shading/a.cpp", "nlohmann/json.hpp"},
        {"scene/a.h", "nlohmann/json.hpp"},
        {"scene/a.cpp", "boost/any.hpp"},
    };
    for (const auto &[path, name] : strays) {
        EXPECT_EQ(broken_walls(path, "  #  include <" + name + ">\n").size(), 1U) << path << " " << name;
    }
    EXPECT_TRUE(broken_walls("scene/a.cpp", "#include <nlohmann/json.hpp>\n").empty());
}

TEST(WallsStand, AgainstOpenGLByName) {
    EXPECT_EQ(broken_walls("measure/a.cpp", "void f() { glFinish(); }\n").size(), 1U);
    EXPECT_EQ(broken_walls("capture/a.cpp", "unsigned target = GL_TEXTURE_2D;\n").size(), 1U);
    EXPECT_TRUE(
        broken_walls("measure/a.cpp", "// glFinish\nauto clock = \"GL_TIME_ELAPSED\"; /* GL_RGBA */\n").empty());
    EXPECT_TRUE(
        broken_walls("measure/a.cpp", "auto page = R\"(\"GL_RGBA)\"; auto c = '\"'; int glm_glance = 0;\n").empty());
}

TEST(WallsStand, AgainstJsonThatLeaksThroughAHeader) {
    const std::string header = "#include <nlohmann/json_fwd.hpp>\n";
    const std::string user = "#include \"scene/scene_json.h\"\n";
    EXPECT_EQ(leaked_json({{"scene/scene_json.h", header}, {"capture/sidecar.cpp", user}}).size(), 1U);
    EXPECT_TRUE(leaked_json({{"scene/scene_json.h", header}, {"scene/scene_file.cpp", user}}).empty());
}

} // namespace
} // namespace sandbox
