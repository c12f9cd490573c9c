#include "commands/gl_command_test.h"
#include "image/pfm.h"
#include "image/png.h"
#include "measure/metrics/profile.h"
#include "measure/report/paper.h"
#include "measure/report/text.h"
#include "scene/scene_file.h"
#include "tools/xml.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

/// The hand-in of the built program.
namespace sandbox {
namespace {

class FiguresGl : public GlCommandTest {
  protected:
    [[nodiscard]] ProcessResult figures(const std::string &scene, Arguments more = {}) const {
        more.insert(more.begin(), {"figures", scene, "--out", folder.file("out"), "--size", "64x48"});
        return run_sandbox(more);
    }
    [[nodiscard]] std::string written(const std::string &name) const { return folder.read("out/" + name); }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto &entry : std::filesystem::directory_iterator(folder.file("out"))) {
            names.push_back(entry.path().filename().string());
        }
        std::ranges::sort(names);
        return names;
    }
    [[nodiscard]] Size size_of(const std::string &name) const { return decode_png(written(name), name).size; }
    /// The commands of index.md that begin with `shading-sandbox NAME `, as arguments.
    [[nodiscard]] std::vector<Arguments> commands(const std::string &name) const {
        std::vector<Arguments> found;
        std::istringstream lines(written("index.md"));
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("shading-sandbox " + name + " ")) {
                std::istringstream words(line.substr(line.find(' ') + 1));
                found.emplace_back();
                for (std::string word; words >> word;) {
                    found.back().push_back(word);
                }
            }
        }
        return found;
    }
    /// The cells of a row of errors as the page has it for what `compare` says.
    static std::string cells_of(const nlohmann::json &compared) {
        return fmt::format("| {} | {} | {} | {} |", short_number(compared["max_abs"].get<double>()),
                           compared["max_levels"].get<int>(), short_number(compared["rmse"].get<double>()),
                           short_number(255 * compared["rmse"].get<double>()));
    }
};

const std::vector<std::string> all_files{"difference.png",
                                         "difference.png.json",
                                         "error-time.png",
                                         "error-time.svg",
                                         "exponents.png",
                                         "exponents.png.json",
                                         "index.md",
                                         "pair.png",
                                         "pair.png.json",
                                         "profile-line.png",
                                         "profile-line.png.json",
                                         "profile.png",
                                         "profile.svg",
                                         "subdivision-error.png",
                                         "subdivision-error.svg",
                                         "subdivision.png"};

TEST_F(FiguresGl, TheIndexListsExactlyTheFiles) {
    const ProcessResult result = figures("three-point-lights");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(names(), all_files);
    const std::string page = written("index.md");
    std::set<std::string> linked{"index.md"};
    const std::regex link(R"(\]\(([^)]+)\))");
    for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at) {
        linked.insert((*at)[1]);
    }
    EXPECT_EQ(std::vector<std::string>(linked.begin(), linked.end()), all_files);
    for (int number = 1; number <= 6; ++number) {
        EXPECT_NE(page.find(fmt::format("**Figure {}.**", number)), std::string::npos);
    }
    EXPECT_EQ(page.find("**Figure 7.**"), std::string::npos);

    EXPECT_EQ(size_of("pair.png").width, 128) << "two views of 64";
    EXPECT_GE(size_of("pair.png").height, 48);
    EXPECT_EQ(size_of("profile-line.png"), size_of("pair.png"));
    EXPECT_EQ(size_of("difference.png").width, 64);
    EXPECT_EQ(size_of("exponents.png").width, 4 * 32);
    EXPECT_GE(size_of("exponents.png").height, 2 * 32);
    EXPECT_EQ(size_of("subdivision.png").width, 5 * 32) << "four rungs and the truth";
    for (const std::string &name : all_files) {
        if (name.ends_with(".svg")) {
            const std::string svg = written(name);
            EXPECT_TRUE(well_formed(svg)) << name;
            std::smatch size;
            ASSERT_TRUE(std::regex_search(svg, size, std::regex(R"re(width="(\d+)" height="(\d+)")re")));
            const Size png = size_of(name.substr(0, name.size() - 3) + "png");
            EXPECT_EQ(png, (Size{2 * std::stoi(size[1]), 2 * std::stoi(size[2])})) << name;
        }
    }
}

/// Every number against what `compare` prints, every picture against what `capture` draws.
TEST_F(FiguresGl, ItsCommandsGiveItsNumbersAndPicturesAgain) {
    ASSERT_EQ(
        figures("box-4-normal-matrix", {"--set", "objects[1].mesh.rings=12", "--left", "per-vertex/phong"}).exit_code,
        0);
    const std::string page = written("index.md");
    const std::vector<Arguments> compares = commands("compare");
    ASSERT_EQ(compares.size(), 3U) << "A, B, and A against B";
    for (Arguments compare : compares) {
        std::ranges::replace(compare, "'objects[1].mesh.rings=12'", "objects[1].mesh.rings=12");
        compare.emplace_back("--json");
        const ProcessResult result = run_sandbox(compare);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const auto compared = nlohmann::json::parse(result.out);
        EXPECT_EQ(compared["size"], "64x48");
        EXPECT_NE(page.find(cells_of(compared)), std::string::npos) << cells_of(compared) << "\n" << page;
    }
    const std::vector<Arguments> captures = commands("capture");
    ASSERT_EQ(captures.size(), 4U);
    for (Arguments capture : captures) {
        const std::string before = written(std::filesystem::path(capture.back()).filename().string());
        capture.back() = folder.file("again.png");
        ASSERT_EQ(run_sandbox(capture).exit_code, 0);
        EXPECT_EQ(folder.read("again.png"), before) << capture[1];
    }
}

/// The profile's curves are the views' own pixels: half a unit of the plot is 0.2 % of its height.
TEST_F(FiguresGl, TheProfileIsThePicturesRow) {
    ASSERT_EQ(figures("point-light").exit_code, 0);
    const std::string svg = written("profile.svg");
    std::smatch row;
    ASSERT_TRUE(std::regex_search(svg, row, std::regex(R"(Luminance along row (\d+))")));
    for (const auto &[technique, style] :
         {std::pair("per-vertex/blinn-phong", style_a), std::pair("per-pixel/blinn-phong", style_b)}) {
        ASSERT_EQ(run_sandbox({"capture", "point-light", "--technique", technique, "--size", "64x48", "--out",
                               folder.file("view.pfm")})
                      .exit_code,
                  0);
        const Curve curve = luminance_row(decode_pfm(folder.read("view.pfm"), "view.pfm"), std::stoi(row[1]));
        const std::string begin = fmt::format("<g class=\"s{}\"><path class=\"line\" d=\"M", style);
        const std::size_t at = svg.find(begin);
        ASSERT_NE(at, std::string::npos);
        std::string path = svg.substr(at + begin.size(), svg.find('"', at + begin.size()) - at - begin.size());
        std::ranges::replace(path, 'L', ' ');
        std::istringstream numbers(path);
        std::vector<double> heights;
        for (double x = 0, y = 0; numbers >> x >> y;) {
            heights.push_back(y);
        }
        ASSERT_EQ(heights.size(), 64U);
        // The axis is linear: two pixels tell its scale, all others must follow it.
        const auto [low, high] = std::ranges::minmax_element(curve);
        const auto i = static_cast<std::size_t>(low - curve.begin()),
                   j = static_cast<std::size_t>(high - curve.begin());
        const double scale = (heights[j] - heights[i]) / (curve[j] - curve[i]);
        EXPECT_LT(scale, 0) << "upwards";
        for (std::size_t x = 0; x < curve.size(); ++x) {
            EXPECT_NEAR(heights[x], heights[i] + scale * (curve[x] - curve[i]), 0.5) << "column " << x;
        }
    }
}

/// A mesh from a file has no ladder, and there is no sphere: one stands in, and the captions say so.
TEST_F(FiguresGl, AnObjGetsASphereAndSaysSo) {
    folder.write("a cube.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 0 2\nf 3 2 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    ASSERT_EQ(figures(folder.file("a cube.obj")).exit_code, 0);
    EXPECT_EQ(names(), all_files);
    const std::string page = written("index.md");
    EXPECT_NE(page.find("Meshes from files cannot be made finer, so that a sphere stands for the scene."),
              std::string::npos);
    EXPECT_NE(page.find("The scene has no round sphere"), std::string::npos);
    EXPECT_NE(page.find("compare '" + folder.file("a cube.obj") + "'"), std::string::npos) << "quoted";
    EXPECT_NE(page.find("per vertex, Blinn-Phong. B, on the right: per pixel, Blinn-Phong"), std::string::npos);
}

/// Where nothing differs, no plot is drawn that would be empty.
TEST_F(FiguresGl, ASceneWithoutErrorsHasNoPlotOfThem) {
    const ProcessResult result = figures("box-1-colour");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("draw the same picture"), std::string::npos);
    const std::vector<std::string> files = names();
    EXPECT_EQ(std::ranges::count(files, "error-time.svg"), 0);
    EXPECT_EQ(std::ranges::count(files, "profile.svg"), 1);
    EXPECT_NE(written("index.md").find("No error there is above 0"), std::string::npos);
    EXPECT_NE(written("index.md").find("A and B differ nowhere"), std::string::npos);
}

TEST_F(FiguresGl, CaptionsSpeakChinese) {
    ASSERT_EQ(figures("box-5-specular", {"--lang", "zh"}).exit_code, 0);
    const std::string page = written("index.md");
    EXPECT_NE(page.find("**图 1.** A 与 B 并列。左边为 A：逐顶点，Phong。"), std::string::npos);
    EXPECT_EQ(page.find("Figure"), std::string::npos);
    const std::string description = open_scene("box-5-specular", Assets("assets")).description;
    ASSERT_FALSE(description.empty());
    EXPECT_EQ(page.find(description), std::string::npos); // it is in Chinese, too
    EXPECT_NE(written("profile.svg").find("亮度"), std::string::npos);
}

TEST_F(FiguresGl, ARefusedTechniqueAndAnInterruptLeaveTheFolderAsItWas) {
    std::string lights;
    for (int i = 0; i < 20; ++i) {
        lights += std::string(i > 0 ? "," : "") + R"({"type": "point", "position": [1, 2, 3]})";
    }
    folder.write("many.json", R"({"lights": [)" + lights + R"(], "objects": [{"mesh": {"shape": "sphere"}}]})");
    const ProcessResult refused = figures(folder.file("many.json"), {"--right", "interpolated-vectors/blinn-phong"});
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    EXPECT_NE(refused.err.find("components between the shader stages"), std::string::npos) << refused.err;
    EXPECT_TRUE(names().empty());
    // Long enough to be interrupted on any machine.
    const ProcessResult stopped =
        run_sandbox({"figures", "three-point-lights", "--out", folder.file("out"), "--size", "2000x1500"},
                    "timeout --preserve-status -s INT 3");
    EXPECT_EQ(stopped.exit_code, 130) << stopped.err;
    EXPECT_TRUE(names().empty());
}

} // namespace
} // namespace sandbox
