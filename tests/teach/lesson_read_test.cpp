#include "teach/files/taught_file.h"
#include "teach/lesson_read.h"

#include "image/file_io.h"
#include "image/write_files.h"
#include "scene/scene_file.h"
#include "teach/lesson_format.h"
#include "tools/error_of.h"
#include "tools/json_schema.h"
#include "tools/temporary_folder.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace sandbox {
namespace {

const Assets assets("assets");

Lesson parse(const std::string &text, const std::string &language = "en") {
    const Words words(language, R"({"hello": "Hello"})", "words/en.json");
    return parse_lesson(text, "mine.json", {}, assets, words);
}
std::string lesson_of(const std::string &steps) { return R"({"title": "T", "steps": [)" + steps + "]}"; }
/// A step with these keys beside its title, text and a claim.
std::string step_of(const std::string &keys) {
    const std::string begin = R"({"title": "t", "text": "x", "claims": [{"metric": "max_abs", "below": 1}])";
    return begin + (keys.empty() ? "" : ", ") + keys + "}";
}
std::string claim_of(const std::string &claim) {
    return lesson_of(R"({"title": "t", "text": "x", "scene": "point-light", "claims": [)" + claim + "]}");
}
std::string error(const std::string &text) {
    return error_of([&] { parse(text); });
}

TEST(LessonRead, TakesOverSceneAndTechniquesFromStepToStep) {
    const Lesson lesson = parse(
        lesson_of(step_of(R"("scene": "box-4-normal-matrix", "left": "flat/lambert", "right": "per-vertex/phong")") +
                  "," + step_of(R"("set": ["lights[0].diffuse=0.25"], "right": "per-pixel/phong")") + "," +
                  step_of(R"("camera": {"position": [1, 2, 3]}, "mesh_factors": [0.25, 4], "layout": "difference",
                             "display": "srgb", "look": {"at": [0.2, 0.3]}, "wireframe": true,
                             "question": {"asks": "?", "answer": "!"})")));
    EXPECT_EQ(lesson.name, "mine");
    ASSERT_EQ(lesson.steps.size(), 3U);
    EXPECT_EQ(lesson.steps[0].scene, open_scene("box-4-normal-matrix", assets));
    const LessonStep &last = lesson.steps[2];
    EXPECT_EQ(last.scene.lights[0].diffuse, 0.25);
    EXPECT_EQ(last.scene.camera.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(last.left, parse_technique("flat/lambert"));
    EXPECT_EQ(last.right, parse_technique("per-pixel/phong"));
    EXPECT_EQ(last.layout, StepLayout::difference);
    EXPECT_EQ(last.display, Display::srgb);
    EXPECT_EQ(last.mesh_factors, glm::dvec2(0.25, 4));
    EXPECT_EQ(last.look->at, glm::dvec2(0.2, 0.3));
    EXPECT_EQ(last.question->answer.text, "!");
}

TEST(LessonRead, ScenesAreNamesPathsOrWrittenOut) {
    const TemporaryFolder folder;
    folder.write("own.json",
                 R"({"objects": [{"mesh": {"shape": "box"}}], "lights": [{"type": "point", "position": [1, 1, 1]}]})");
    folder.write("lesson.json", lesson_of(step_of(R"("scene": "own.json")")));
    EXPECT_EQ(open_lesson(folder.file("lesson.json"), assets, {}).steps[0].scene.objects.size(), 1U);
    EXPECT_EQ(parse(lesson_of(step_of(R"("scene": {"ambient": [1, 1, 1]})"))).steps[0].scene.ambient, glm::dvec3(1));
    const Scene green = with_view(open_scene("three-point-lights", assets), "from-the-green-light");
    EXPECT_EQ(
        parse(lesson_of(step_of(R"("scene": "three-point-lights", "camera": "from-the-green-light")"))).steps[0].scene,
        green);
}

TEST(LessonRead, ATextIsPlainKeyedOrInTwoLanguages) {
    const auto title = [](const std::string &json, const std::string &language = "en") {
        return parse(R"({"title": )" + json + R"(, "steps": [)" + step_of(R"("scene": "point-light")") + "]}", language)
            .title.text;
    };
    EXPECT_EQ(title(R"("plain")"), "plain");
    EXPECT_EQ(title(R"("@hello")"), "Hello");
    EXPECT_EQ(title(R"({"en": "one", "zh": "一"})", "zh"), "一");
    EXPECT_EQ(title(R"({"en": "one"})", "zh"), "one") << "the language that there is";
    EXPECT_EQ(error_of([&] { title(R"("@helo")"); }), "mine.json: title: words/en.json has no text \"helo\"");
    EXPECT_EQ(error_of([&] { title(R"({"eng": "one"})"); }),
              "mine.json: title.eng: unknown language; did you mean \"en\"?");
}

TEST(LessonRead, AFamousBugSaysWhatWasSeenTheCureAndItsSource) {
    const std::string steps = R"("steps": [)" + step_of(R"("scene": "point-light")") + "]}";
    const Lesson bug = parse(R"({"title": "T", "seen": "s", "cure": "c", "source": "engine 1", )" + steps);
    EXPECT_TRUE(bug.is_bug());
    EXPECT_EQ(bug.cure.text, "c");
    EXPECT_FALSE(parse(R"({"title": "T", )" + steps).is_bug());
    EXPECT_EQ(error(R"({"title": "T", "seen": "s", "source": "engine 1", )" + steps),
              "mine.json: cure: expected seen, cure and source together");
    EXPECT_EQ(error(R"({"title": "T", "seen": "s", )" + steps),
              "mine.json: seen: expected seen, cure and source together");
}

TEST(LessonRead, AStepDrawsOverlaysByTheirWords) {
    const Lesson lesson = parse(lesson_of(step_of(R"("scene": "point-light", "normals": true)")));
    EXPECT_EQ(static_cast<const Overlays &>(lesson.steps[0]), (Overlays{.normals = true}));
}

TEST(LessonRead, ALessonFileIsToldFromAScene) {
    const TemporaryFolder folder;
    folder.write("lesson.json", lesson_of("{}")); // a bad one is one, too
    folder.write("scene.json", R"({"name": "x", "lights": []})");
    folder.write("broken.json", "{");
    folder.write("lesson.txt", lesson_of("{}"));
    EXPECT_EQ(taught_file(folder.file("lesson.json")), TaughtFile::lesson);
    for (const char *other : {"scene.json", "broken.json", "lesson.txt", "absent.json"}) {
        EXPECT_NE(taught_file(folder.file(other)), TaughtFile::lesson) << other;
    }
}

TEST(LessonRead, AStepThatAssertsHasAClaimThatIsChecked) {
    const std::string step = R"({"title": "t", "text": "x", "scene": "point-light")";
    const std::string wanted = "mine.json: steps[0].claims: expected a claim that is checked, or \"asserts\": false";
    EXPECT_EQ(error(lesson_of(step + "}")), wanted);
    EXPECT_EQ(error(lesson_of(step + R"(, "claims": [{"metric": "run_time"}]})")), wanted) << "it is only shown";
    EXPECT_EQ(parse(lesson_of(step + R"(, "asserts": false})")).steps.size(), 1U);
}

TEST(LessonRead, ErrorsNameFileKeyAndWhatWasExpected) {
    EXPECT_TRUE(error("{").starts_with("mine.json:1:2: syntax error")) << error("{");
    EXPECT_EQ(error("{}"), "mine.json: title: missing; expected a text, \"@key\" or {\"en\": ..., \"zh\": ...}");
    EXPECT_EQ(error(R"({"title": "a", "steps": []})"), "mine.json: steps: expected one step or more, got []");
    EXPECT_EQ(error(R"({"titel": "a"})"), "mine.json: titel: unknown key of this lesson; did you mean \"title\"?");
    EXPECT_EQ(error(lesson_of(step_of(""))),
              "mine.json: steps[0].scene: missing; expected a scene: there is no step before this one");
    EXPECT_EQ(error(lesson_of(step_of(R"("scene": "point-lihgt")"))),
              "mine.json: steps[0].scene: point-lihgt: no built-in scene of that name; did you mean \"point-light\"?");
    EXPECT_TRUE(error(lesson_of(step_of(R"("scene": {"ambeint": [1, 1, 1]})")))
                    .starts_with("mine.json: steps[0].scene: ambeint: unknown key of this scene"));
    EXPECT_EQ(error(lesson_of(step_of(R"("scene": "point-light", "layout": "sideways")"))),
              "mine.json: steps[0].layout: expected one of \"single\", \"side-by-side\", \"wipe\", \"difference\", "
              "\"three-up\", got \"sideways\"");
    EXPECT_EQ(error(lesson_of(step_of(R"("scene": "point-light", "tab": "profile")"))),
              "mine.json: steps[0].tab: expected the key of a tab, one letter, got \"profile\"");
    EXPECT_TRUE(error(lesson_of(step_of(R"("scene": "point-light", "left": "per-pixel/fong")")))
                    .starts_with("mine.json: steps[0].left: "));
    EXPECT_TRUE(error(lesson_of(step_of(R"("scene": "point-light", "set": ["lights[9].diffuse=1"])")))
                    .starts_with("mine.json: steps[0].set lights[9].diffuse"));
}

TEST(LessonRead, AClaimIsOneNumberAndOneBound) {
    const auto said = [](const std::string &claim) {
        std::string text = error(claim_of(claim));
        return text.substr(std::min(text.size(), text.find("claims[0]") + 9));
    };
    EXPECT_EQ(said(R"({"below": 1})"), ": expected metric, or has and lacks");
    EXPECT_EQ(said(R"({"metric": "max_abs"})"), ": expected one of below, above, equals, about");
    EXPECT_EQ(said(R"({"metric": "max_abs", "below": 1, "above": 0})"),
              ": expected one of below, above, equals, about");
    EXPECT_EQ(said(R"({"metric": "max_ab", "below": 1})"), ".metric: unknown metric, got \"max_ab\"; did you mean "
                                                           "\"max_abs\"?");
    EXPECT_EQ(said(R"({"metric": "max_abs", "about": 1})"), ": expected about and within together");
    EXPECT_EQ(said(R"({"metric": "max_abs", "about": 1, "within": 1})"), ".within: expected a number > 1, got 1");
    EXPECT_EQ(said(R"({"metric": "run_time", "below": 1})"), ": expected no bound: a run time is shown, never checked");
    EXPECT_EQ(said(R"({"has": ["pow"], "equals": 0})"), ": expected no bound beside has and lacks");
    EXPECT_EQ(said(R"({"has": ["pow"], "stage": "pixel"})"), R"(.stage: expected "vertex" or "fragment", got "pixel")");
    EXPECT_EQ(said(R"({"metric": "rmse", "below": 1, "meshes": [2, 1]})"),
              ".meshes: expected two mesh factors or more, ascending, got [2,1]");
    EXPECT_EQ(said(R"({"metric": "rmse", "below": 1, "region": [0.5, 0, 0.4, 1]})"),
              ".region: expected left < right and top < bottom, got [0.5,0,0.4,1]");
    EXPECT_EQ(said(R"({"metric": "rmse", "below": 1, "size": "big"})").substr(0, 7), ".size: ");
    EXPECT_EQ(said(R"({"metric": "rmse", "below": 1, "of": "middle"})").substr(0, 5), ".of: ");
    EXPECT_EQ(said(R"({"metric": "rmse", "below": 1, "motion": {"mover": "light"}})"),
              ": motion.index: missing, or of the wrong type");
}

const std::filesystem::path schema_file = std::filesystem::path(SOURCE_DIR) / "assets/lesson.schema.json";

TEST(LessonSchema, IsUpToDate) {
    if (std::getenv("SANDBOX_UPDATE_SCHEMA") != nullptr) {
        write_file(schema_file, lesson_schema());
    }
    EXPECT_EQ(read_file(schema_file), lesson_schema())
        << "the lesson format has changed; run the tests once with SANDBOX_UPDATE_SCHEMA=1 to write "
        << "assets/lesson.schema.json anew, and say so in the CHANGELOG";
}

/// Of the gallery, too.
std::vector<std::string> lesson_files() {
    std::vector<std::string> files = assets.list("lessons/");
    for (const std::string &path : assets.list("gallery/")) {
        files.push_back(path);
    }
    return files;
}

TEST(LessonSchema, AcceptsTheBuiltInLessonsAndRefusesOtherKeys) {
    const auto schema = nlohmann::json::parse(lesson_schema());
    for (const std::string &path : lesson_files()) {
        EXPECT_TRUE(SchemaValidator(schema).accepts(nlohmann::json::parse(*assets.read(path)))) << path;
    }
    auto lesson = nlohmann::json::parse(lesson_of(step_of(R"("scene": "point-light")")));
    EXPECT_TRUE(SchemaValidator(schema).accepts(lesson));
    lesson["steps"][0]["claims"][0]["metric"] = "max_ab";
    EXPECT_FALSE(SchemaValidator(schema).accepts(lesson));
    lesson["steps"][0].erase("claims");
    lesson["steps"][0]["txt"] = "x";
    EXPECT_FALSE(SchemaValidator(schema).accepts(lesson));
}

std::size_t words_in(const std::string &text) {
    std::istringstream words(text);
    return static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(words), {}));
}

TEST(BuiltInLessons, AreShortAndWhole) {
    std::vector<Lesson> lessons = builtin_bugs(assets, words_in("en", assets));
    EXPECT_GE(lessons.size(), 15U);
    for (const Lesson &lesson : builtin_lessons(assets, words_in("en", assets))) {
        EXPECT_FALSE(lesson.is_bug());
        lessons.push_back(lesson);
    }
    for (const Lesson &lesson : lessons) {
        EXPECT_FALSE(lesson.about.text.empty()) << lesson.name;
        for (const LessonStep &step : lesson.steps) {
            EXPECT_LE(words_in(step.text.text), 60U) << lesson.name << ": " << step.title.text;
        }
    }
}

/// Every technique that a step or one of its claims draws.
std::vector<Technique> techniques_of(const LessonStep &step) {
    std::vector<Technique> all{*step.left, *step.right};
    for (const LessonClaim &claim : step.claims) {
        for (const auto &source : {std::optional(claim.of), claim.against, claim.than}) {
            if (source && source->kind == PictureSource::Kind::technique) {
                all.push_back(source->technique);
            }
        }
    }
    return all;
}

TEST(BuiltInLessons, MeasureEveryFault) {
    std::set<std::string> measured;
    for (const Lesson &lesson : builtin_lessons(assets, words_in("en", assets))) {
        for (const LessonStep &step : lesson.steps) {
            for (const Technique &technique : step.claims.empty() ? std::vector<Technique>{} : techniques_of(step)) {
                for (const TechniqueKey &key : technique_settings) {
                    measured.insert(fmt::format("{}={}", key.name, key.value(technique).name));
                }
            }
        }
    }
    for (const TechniqueKey &key : technique_settings) {
        for (const TechniqueValue &value : key.values) {
            const std::string setting = fmt::format("{}={}", key.name, value.name);
            EXPECT_TRUE(!key.is_fault() || measured.contains(setting)) << setting << " is in no lesson";
        }
    }
}

/// The texts stand in words/, for translators: no lesson holds its own, and no text is left over.
TEST(BuiltInLessons, HoldKeysOfTexts) {
    std::set<std::string> used, known;
    for (const std::string &path : lesson_files()) {
        const auto lesson = nlohmann::json::parse(*assets.read(path));
        const auto take = [&](const nlohmann::json &from, std::initializer_list<const char *> keys) {
            for (const char *key : keys) {
                if (from.contains(key)) {
                    const auto text = from[key].get<std::string>();
                    EXPECT_TRUE(text.starts_with('@')) << path << ": " << text;
                    used.insert(text.substr(1));
                }
            }
        };
        take(lesson, {"title", "about", "seen", "cure"});
        for (const auto &step : lesson["steps"]) {
            take(step, {"title", "text"});
            take(step.value("question", nlohmann::json::object()), {"asks", "answer"});
            for (const auto &claim : step.value("claims", nlohmann::json::array())) {
                take(claim, {"says"});
            }
        }
    }
    const auto words = nlohmann::json::parse(*assets.read("words/en.json"));
    for (const auto &[key, text] : words.items()) {
        if (key.starts_with("lesson.") || key.starts_with("bug.")) { // others are the window's
            known.insert(key);
        }
    }
    EXPECT_EQ(used, known);
}

} // namespace
} // namespace sandbox
