#include "commands/gl_command_test.h"

#include "tools/answer_class.h"
#include "tools/hostile_answers.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

/// `mark` of the built program.
namespace sandbox {
namespace {

namespace fs = std::filesystem;

class MarkGl : public GlCommandTest {
  protected:
    nlohmann::json marks(const std::string &exercise, const std::string &answers, const Arguments &more = {}) const {
        Arguments arguments{"mark", exercise, answers, "--json", folder.file("marks.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return nlohmann::json::parse(folder.read("marks.json"))["answers"];
    }
    /// Files of a folder and what they hold.
    std::map<std::string, std::string> contents(const std::string &name) const {
        std::map<std::string, std::string> all;
        for (const fs::directory_entry &entry : fs::directory_iterator(folder.path() / name)) {
            all[entry.path().filename().string()] = folder.read(name + "/" + entry.path().filename().string());
        }
        return all;
    }
};

TEST_F(MarkGl, TheTextbookGetsEveryPointOfEveryExercise) {
    const auto list = nlohmann::json::parse(run_sandbox({"list", "--json"}).out);
    ASSERT_GE(list["exercises"].size(), 10U);
    for (const auto &exercise : list["exercises"]) {
        const std::string name = exercise["name"];
        const std::string file = folder.file(name + ".glsl");
        ASSERT_EQ(run_sandbox({"own", "--answer", "--technique", exercise["target"], "--out", file}).exit_code, 0);
        if (name == "normal-matrix") { // which asks for more than the textbook's text has
            const std::string text = folder.read(name + ".glsl");
            folder.write(name + ".glsl",
                         text +
                             "vec3 normal(vec3 n) { return normalize(transpose(inverse(mat3(model_matrix))) * n); }\n");
        }
        EXPECT_EQ(marks(name, file)[0]["points"], exercise["points"]) << name << folder.read("marks.json");
    }
}

/// No right answer loses a point; a wrong line costs its term and no other.
TEST_F(MarkGl, AClassIsMarkedTermByTerm) {
    for (const char *exercise : {"phong", "spot-light"}) {
        const std::string name = exercise;
        const std::vector<std::string> terms = name == "phong"
                                                   ? std::vector<std::string>{"ambient", "diffuse", "specular", "sum"}
                                                   : std::vector<std::string>{"ambient", "diffuse", "specular", "cone"};
        const Technique target = parse_technique(name == "phong" ? "per-pixel/phong" : "per-pixel/blinn-phong");
        const auto answers = answer_class(target, terms, 16, 3);
        fs::create_directory(folder.path() / name);
        for (const ClassAnswer &answer : answers) {
            folder.write(name + "/" + answer.name, answer.text);
        }
        const auto marked = marks(name, folder.file(name), {"--hints", "3"});
        ASSERT_EQ(marked.size(), answers.size());
        for (std::size_t i = 0; i < answers.size(); ++i) {
            std::set<std::string> lost;
            for (const auto &term : marked[i]["terms"]) {
                if (term["points"] < term["of"]) {
                    lost.insert(term["term"]);
                }
            }
            const std::set<std::string> owed =
                answers[i].fault.empty() ? std::set<std::string>{} : std::set<std::string>{answers[i].term};
            EXPECT_EQ(marked[i]["name"], answers[i].name);
            EXPECT_EQ(lost, owed) << name << " " << answers[i].name << marked[i].dump(1) << answers[i].text;
        }
    }
}

TEST_F(MarkGl, MarkingAgainGivesTheSameBytesInBothLanguages) {
    fs::create_directory(folder.path() / "in");
    for (const ClassAnswer &answer : answer_class(parse_technique("per-pixel/lambert"), {"diffuse"}, 4, 5)) {
        folder.write("in/" + answer.name, answer.text);
    }
    for (const char *language : {"en", "zh"}) {
        std::map<std::string, std::string> first;
        for (const char *out : {"one", "two"}) {
            const std::string name = std::string(out) + language;
            const ProcessResult result = run_sandbox(
                {"mark", "lambert", folder.file("in"), "--out", folder.file(name), "--lang", language, "--hints", "3"});
            ASSERT_EQ(result.exit_code, 0) << result.err;
            const auto again = contents(name);
            EXPECT_EQ(again.size(), 7U) << "four pages, index.html, marks.json and marks.csv";
            EXPECT_TRUE(first.empty() || first == again);
            first = again;
        }
        const std::string page = first.begin()->second;
        EXPECT_EQ(page.find("src=\"http"), std::string::npos) << "self-contained";
        EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
        EXPECT_NE(page.find(language == std::string("en") ? "The truth" : "真值"), std::string::npos);
    }
}

TEST_F(MarkGl, AnswersOfOneNameAreKeptApart) {
    const auto answers = answer_class(parse_technique("per-pixel/lambert"), {"diffuse"}, 2, 5);
    for (const char *student : {"ann", "bob"}) {
        fs::create_directory(folder.path() / student);
        folder.write(std::string(student) + "/a.glsl", answers[0].text);
    }
    const ProcessResult result =
        run_sandbox({"mark", "lambert", folder.file("ann"), folder.file("bob/a.glsl"), folder.file("ann/a.glsl"),
                     "--out", folder.file("out"), "--json", folder.file("marks.json")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto marked = nlohmann::json::parse(folder.read("marks.json"))["answers"];
    ASSERT_EQ(marked.size(), 2U) << "the same file twice is one answer";
    EXPECT_EQ(marked[0]["name"], "ann/a.glsl");
    EXPECT_EQ(marked[1]["name"], "bob/a.glsl");
    EXPECT_EQ(contents("out").count("ann_a.glsl.html"), 1U);
}

TEST_F(MarkGl, PicturesAreMarkedByWhatTheyAre) {
    ASSERT_EQ(run_sandbox({"mark", "phong", "--student", folder.file("s")}).exit_code, 0);
    const auto exercise = nlohmann::json::parse(folder.read("s/phong.json"));
    folder.write("scene.json", exercise["scenes"][0]["scene"].dump());
    fs::create_directory(folder.path() / "in");
    const auto capture = [&](const std::string &name, const std::string &technique) {
        EXPECT_EQ(run_sandbox({"capture", folder.file("scene.json"), "--size", "160x120", "--no-sidecar", "--technique",
                               technique, "--out", folder.file("in/" + name)})
                      .exit_code,
                  0);
    };
    capture("1-right.png", "per-pixel/phong");
    capture("2-gate.pfm", "per-pixel/phong:gate=times-n-dot-l");
    fs::copy(fs::path(SOURCE_DIR) / "assets/textures/bricks.png", folder.path() / "in/3-bricks.png");
    const auto marked = marks("phong", folder.file("in"));
    EXPECT_EQ(marked[0]["points"], 10);
    EXPECT_EQ(marked[1]["points"], 5);
    EXPECT_EQ(marked[1]["faults"][0], "gate=times-n-dot-l");
    EXPECT_TRUE(marked[2]["points"].is_null()) << "nothing known explains it";
}

TEST_F(MarkGl, HostileAnswersCostTheirOwnPointsAndNothingElse) {
    folder.write("outside.glsl", "keep");
    const auto names = write_hostile_answers(folder.path() / "in", folder.path() / "outside.glsl");
    ASSERT_GE(names.size(), 50U);
    ASSERT_EQ(
        run_sandbox({"own", "--answer", "--technique", "per-pixel/lambert", "--out", folder.file("in/right.glsl")})
            .exit_code,
        0);
    fs::create_directory(folder.path() / "out");
    fs::create_symlink(folder.path() / "outside.glsl", folder.path() / "out/empty.glsl.html");
    const std::set<fs::path> before(fs::directory_iterator(folder.path()), {});
    const ProcessResult result = run_sandbox({"mark", "ambient", folder.file("in"), "--out", folder.file("out")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(folder.read("outside.glsl"), "keep");
    EXPECT_EQ(std::set<fs::path>(fs::directory_iterator(folder.path()), {}), before);

    const auto marked = nlohmann::json::parse(folder.read("out/marks.json"))["answers"];
    ASSERT_EQ(marked.size(), names.size() + 1);
    for (const auto &answer : marked) {
        const bool right = answer["name"] == "right.glsl";
        EXPECT_EQ(answer["points"], right ? 8 : 0) << answer.dump(1);
        EXPECT_FALSE(answer["said"].empty()) << answer["name"];
        for (const std::string sentence : answer["said"]) {
            EXPECT_LT(sentence.size(), 2000U);
        }
    }
    EXPECT_EQ(contents("out").size(), marked.size() + 3) << "a page for each";
    for (const auto &[name, text] : contents("out")) {
        EXPECT_EQ(text.find("<script>alert"), std::string::npos) << name;
        EXPECT_EQ(text.find('\x1B'), std::string::npos) << name;
    }
    const std::string csv = folder.read("out/marks.csv");
    for (const char *cell : {"\n=", "\n+", "\n-", "\n@", "\n\t", ",=", ",+", ",@", "\"="}) {
        EXPECT_EQ(csv.find(cell), std::string::npos) << cell;
    }
    EXPECT_EQ(result.out.find('\x1B'), std::string::npos);
}

} // namespace
} // namespace sandbox
