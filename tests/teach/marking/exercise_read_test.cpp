#include "image/file_io.h"
#include "image/write_files.h"
#include "scene/scene_file.h"
#include "shading/own_files.h"
#include "teach/marking/exercise_format.h"
#include "teach/marking/exercise_read.h"
#include "tools/english.h"
#include "tools/error_of.h"
#include "tools/json_schema.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

const Assets assets("assets");
const std::string plain_terms = R"([{"term": "diffuse"}])";

std::string exercise_of(const std::string &keys, const std::string &scenes = R"([{"scene": "point-light"}])",
                        const std::string &terms = plain_terms) {
    return R"({"title": "T", "task": "Do it.", "scenes": )" + scenes + R"(, "terms": )" + terms +
           (keys.empty() ? "" : ", ") + keys + "}";
}
Exercise parse(const std::string &text) { return parse_exercise(text, "mine.json", {}, assets, english); }
std::string error(const std::string &text) {
    return error_of([&] { parse(text); });
}

TEST(ExerciseRead, TakesScenesTermsAndTarget) {
    const Exercise exercise = parse(exercise_of(
        R"("target": "per-vertex/lambert", "size": "80x60")",
        R"([{"name": "lamp", "scene": "point-light"}, {"set": ["lights[0].diffuse=0.25"], "withheld": true},
            {"set": ["lights[0].attenuation.quadratic=1e9"], "stiff": true}])",
        R"([{"term": "diffuse", "points": 3, "tolerance": 0.01}, {"term": "ambient"}, {"term": "robustness", "points": 2}])"));
    EXPECT_EQ(exercise.name, "mine");
    EXPECT_EQ(exercise.target, parse_technique("per-vertex/lambert"));
    EXPECT_EQ(exercise.size, (Size{80, 60}));
    EXPECT_EQ(exercise.points(), 6);
    EXPECT_EQ(exercise.find(MarkTerm::diffuse)->tolerance, 0.01);
    EXPECT_EQ(exercise.find(MarkTerm::ambient)->tolerance, 1.0 / 255);
    EXPECT_EQ(exercise.find(MarkTerm::cone), nullptr);
    ASSERT_EQ(exercise.scenes.size(), 3U);
    EXPECT_EQ(exercise.scenes[0].name, "lamp");
    EXPECT_EQ(exercise.scenes[1].name, "2");
    EXPECT_EQ(exercise.scenes[1].scene.lights[0].diffuse, 0.25);
    EXPECT_EQ(exercise.scenes[2].scene.lights[0].diffuse, 0.85) << "of the first scene, not of the one before";
}

TEST(ExerciseRead, RefusesWithFileAndKey) {
    EXPECT_EQ(error("{"), error("{")) << "no crash";
    EXPECT_EQ(error(exercise_of(R"("titel": 1)")).substr(0, 11), "mine.json: ");
    EXPECT_EQ(
        error(exercise_of(R"("target": "hybrid/phong")")),
        "mine.json: target: expected flat, per-vertex or per-pixel with a model and no keys, got \"hybrid/phong\"");
    EXPECT_EQ(error(exercise_of(R"("target": "per-pixel/phong:gate=none")")).substr(0, 18), "mine.json: target:");
    EXPECT_EQ(error(exercise_of(R"("size": "4000x4000")")),
              "mine.json: size: expected at most 262144 pixels, got \"4000x4000\"");
    EXPECT_EQ(error(exercise_of("", "[]")),
              "mine.json: scenes: expected one scene or more, the first neither withheld nor stiff");
    EXPECT_EQ(error(exercise_of("", R"([{"scene": "point-light", "withheld": true}])")),
              "mine.json: scenes: expected one scene or more, the first neither withheld nor stiff");
    EXPECT_EQ(error(exercise_of("", R"([{"name": "a"}])")),
              "mine.json: scenes[0].scene: missing; expected a scene: there is none before this one");
    EXPECT_EQ(error(exercise_of("", R"([{"scene": "point-light"}])", R"([{"term": "diffuse"}, {"term": "diffuse"}])")),
              "mine.json: terms[1]: expected each term once");
    EXPECT_EQ(error(exercise_of("", R"([{"scene": "point-light"}])", R"([{"term": "robustness"}])")),
              "mine.json: terms: expected robustness where a scene is stiff, and only there");
    EXPECT_EQ(error(exercise_of("", R"([{"scene": "point-light"}])", R"([{"term": "diffuse", "points": 0}])")),
              "mine.json: terms[0].points: expected a number > 0, got 0");
    EXPECT_NE(error_of([] { open_exercise("fong", assets, english); }).find("did you mean \"phong\"?"),
              std::string::npos);
}

/// What is withheld is neither there nor to be guessed from what is.
TEST(ExerciseRead, TheStudentsCopyReadsBackWithoutWhatIsWithheld) {
    for (const Exercise &exercise : builtin_exercises(assets, english)) {
        const std::string text = student_copy(exercise);
        const Exercise copy = parse(text);
        std::size_t shown = 0;
        for (const ExerciseScene &scene : exercise.scenes) {
            shown += scene.withheld ? 0 : 1;
            EXPECT_EQ(text.find("\"" + scene.name + "\"") == std::string::npos, scene.withheld) << scene.name;
        }
        EXPECT_EQ(copy.scenes.size(), shown) << exercise.name;
        EXPECT_EQ(copy.shown_scene(), exercise.shown_scene()) << exercise.name;
        EXPECT_EQ(copy.target, exercise.target);
        EXPECT_EQ(copy.task.text, exercise.task.text);
    }
}

TEST(BuiltInExercises, AreTenOrMoreWithWithheldScenes) {
    const auto exercises = builtin_exercises(assets, english);
    EXPECT_GE(exercises.size(), 10U);
    for (const Exercise &exercise : exercises) {
        EXPECT_FALSE(exercise.about.text.empty()) << exercise.name;
        EXPECT_TRUE(std::ranges::any_of(exercise.scenes, &ExerciseScene::withheld)) << exercise.name;
        EXPECT_GT(exercise.points(), 0);
    }
}

TEST(BuiltInExercises, AskForEveryTerm) {
    MarkTerms asked;
    for (const Exercise &exercise : builtin_exercises(assets, english)) {
        asked.merge(exercise.asked());
    }
    EXPECT_EQ(asked.size(), term_count);
}

const std::filesystem::path schema_file = std::filesystem::path(SOURCE_DIR) / "assets/exercise.schema.json";

TEST(ExerciseSchema, IsUpToDate) {
    if (std::getenv("SANDBOX_UPDATE_SCHEMA") != nullptr) {
        write_file(schema_file, exercise_schema());
    }
    EXPECT_EQ(read_file(schema_file), exercise_schema())
        << "the exercise format has changed; run the tests once with SANDBOX_UPDATE_SCHEMA=1 to write "
        << "assets/exercise.schema.json anew, and say so in the CHANGELOG";
}

TEST(ExerciseSchema, AcceptsTheBuiltInExercisesAndRefusesOtherKeys) {
    const auto schema = nlohmann::json::parse(exercise_schema());
    for (const std::string &path : assets.list("exercises/")) {
        EXPECT_TRUE(SchemaValidator(schema).accepts(nlohmann::json::parse(*assets.read(path)))) << path;
    }
    auto exercise = nlohmann::json::parse(exercise_of(""));
    EXPECT_TRUE(SchemaValidator(schema).accepts(exercise));
    exercise["terms"][0]["term"] = "defuse";
    EXPECT_FALSE(SchemaValidator(schema).accepts(exercise));
    exercise["terms"][0]["term"] = "diffuse";
    exercise["scenes"][0]["secret"] = true;
    EXPECT_FALSE(SchemaValidator(schema).accepts(exercise));
}

} // namespace
} // namespace sandbox
