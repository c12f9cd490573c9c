#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "measure/stability/cases.h"
#include "scene/scene_file.h"
#include "teach/lesson_read.h"
#include "teach/marking/exercise_read.h"
#include "teach/marking/student_file.h"
#include "words/words.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace sandbox {
namespace {

void held_scene(const Scene &scene) {
    held(parse_scene(scene_text(scene), "again.json", "/nowhere") == scene, "a scene reads back as it was");
}

void check_exercise(std::string_view bytes, const Assets &assets, const Words &words) {
    const auto read = [&](std::string_view text) { return parse_exercise(text, "a.json", "/nowhere", assets, words); };
    const auto exercise = accepted([&] { return read(bytes); });
    if (!exercise) {
        return;
    }
    for (const ExerciseScene &scene : exercise->scenes) {
        held_scene(scene.scene);
    }
    held(exercise->points() >= 0, "an exercise is worth something");
    // Without what is withheld it may lack a scene that a term needs.
    const std::string copy = student_copy(*exercise);
    if (const auto students = accepted([&] { return read(copy); })) {
        held(student_copy(*students) == copy, "a student's copy reads back as it was");
    }
}

} // namespace

/// A lesson, an exercise or a case of stability, told by the keys that each must have.
void check_taught(std::string_view bytes) {
    static const Assets assets("assets");
    static const Words words = words_in("en", assets);
    if (bytes.find("\"steps\"") != std::string_view::npos) {
        if (const auto lesson = accepted([&] { return parse_lesson(bytes, "a.json", "/nowhere", assets, words); })) {
            held(!lesson->steps.empty(), "a lesson has a step");
        }
    } else if (bytes.find("\"terms\"") != std::string_view::npos) {
        check_exercise(bytes, assets, words);
    } else if (const auto found = accepted([&] { return parse_stability_case(bytes, "a.json", "/nowhere", assets); })) {
        held_scene(found->scene);
        held(!found->techniques.empty() && found->bound > 0, "a case has a technique and a bound");
    }
}

namespace {

using Json = nlohmann::ordered_json;

/// Texts for people are read alike, however long they are.
void shorten(Json &json) {
    constexpr std::size_t most = 60;
    if (json.is_string() && json.get_ref<const std::string &>().size() > most &&
        json.get_ref<const std::string &>().find('=') == std::string::npos) {
        json = "a text";
    } else if (json.is_structured()) {
        std::ranges::for_each(json, shorten);
    }
}

/// A lesson of each step, so that seeds stay small.
std::vector<std::string> lessons_of_steps(const std::string &text) {
    Json lesson = Json::parse(text);
    shorten(lesson);
    const Json steps = std::exchange(lesson["steps"], Json::array());
    std::vector<std::string> seeds;
    for (const Json &step : steps) {
        lesson["steps"] = Json::array({step});
        seeds.push_back(lesson.dump());
    }
    return seeds;
}

} // namespace

std::vector<std::string> taught_seeds() {
    std::vector<std::string> seeds;
    for (const char *folder : {"assets/lessons", "assets/gallery"}) {
        for (const std::string &file : files_in(folder, ".json")) {
            std::ranges::move(lessons_of_steps(file), std::back_inserter(seeds));
        }
    }
    for (const char *folder : {"assets/exercises", "assets/stability/cases"}) {
        for (const std::string &file : files_in(folder, ".json")) {
            Json json = Json::parse(file);
            shorten(json);
            seeds.push_back(json.dump());
        }
    }
    return seeds;
}

} // namespace sandbox
