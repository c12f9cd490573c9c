#include "measure/report/text.h"
#include "measure/stability/cases.h"
#include "render/frame_clock.h"
#include "scene/scene_file.h"
#include "teach/claims.h"
#include "teach/lesson_read.h"
#include "teach/marking/exercise_read.h"
#include "tools/english.h"
#include "words/row_words.h"
#include "words/words.h"

#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <vector>

/// assets/words: every language says the same things.
namespace sandbox {
namespace {

/// {0}, {1:.2f}, ...: the numbers of the values that a text takes.
std::set<std::string> values_of(const std::string &text) {
    static const std::regex value(R"(\{(\d*)(:[^}]*)?\})");
    std::set<std::string> values;
    for (std::sregex_iterator at(text.begin(), text.end(), value), end; at != end; ++at) {
        values.insert((*at)[1]);
    }
    return values;
}

/// Of the rows of all tables.
std::map<std::string, std::string> all_row_texts() {
    std::map<std::string, std::string> texts = row_texts();
    texts.merge(measured_row_texts());
    texts.merge(claim_row_texts());
    const Assets assets("assets");
    std::vector<std::string> own{std::string(gpu_clock), std::string(wall_clock)};
    const auto add = [&](const std::vector<std::string> &more) { own.insert(own.end(), more.begin(), more.end()); };
    for (const std::string &name : builtin_scenes(assets)) {
        add(texts_of(open_scene(name, assets)));
    }
    for (const StabilityCase &told : stability_cases(assets)) {
        add({told.group, told.symptom, told.cause, told.source, told.seen_on});
        add(texts_of(told.scene));
    }
    for (const auto &lessons : {builtin_lessons(assets, english), builtin_bugs(assets, english)}) {
        for (const Lesson &lesson : lessons) {
            for (const LessonStep &step : lesson.steps) {
                add(texts_of(step.scene));
            }
        }
    }
    for (const Exercise &exercise : builtin_exercises(assets, english)) {
        for (const ExerciseScene &scene : exercise.scenes) {
            own.push_back(scene.name);
            add(texts_of(scene.scene));
        }
    }
    std::erase(own, "");
    for (const std::string &text : own) {
        texts.emplace(file_text_key(text), text);
    }
    return texts;
}

TEST(Languages, HaveTheSameKeysAndValues) {
    const std::map<std::string, std::string> rows = all_row_texts();
    for (const std::string_view language : languages) {
        const Words words = words_in(language);
        for (const auto &[key, text] : words.english().all()) {
            const std::string *own = words.find(key);
            if (own == nullptr) {
                ADD_FAILURE() << language << " lacks " << key;
                continue;
            }
            EXPECT_FALSE(own->empty()) << language << " " << key;
            EXPECT_EQ(values_of(*own), values_of(text)) << language << " " << key;
            EXPECT_FALSE(values_of(*own).contains("")) << key << ": values are named by their number";
        }
        for (const auto &[key, text] : words.all()) {
            const bool of_a_row = language != "en" && rows.contains(key);
            EXPECT_TRUE(words.english().find(key) != nullptr || of_a_row) << language << " has more: " << key;
        }
    }
}

/// In English a row's text stands in the row itself, and nowhere else.
TEST(Languages, SayEveryRow) {
    const Words english = words_in("en"), chinese = words_in("zh");
    for (const auto &[key, text] : all_row_texts()) {
        EXPECT_EQ(english.find(key), nullptr) << key;
        EXPECT_NE(chinese.find(key), nullptr) << "zh lacks " << key << ": " << text;
    }
}

TEST(Languages, NameWhatRowsSay) {
    const Words english = words_in("en");
    for (const TechniqueKey &key : technique_keys()) {
        for (int value = 0; value < static_cast<int>(key.values.size()); ++value) {
            EXPECT_EQ(title_of(english, key, value), title_of(key, value));
        }
    }
    const Technique technique = parse_technique("per-vertex/phong:normals=model-matrix,power=stable");
    EXPECT_EQ(title_of(english, technique), title_of(technique));
    EXPECT_NE(title_of(words_in("zh"), technique).find("逐顶点"), std::string::npos);
}

} // namespace
} // namespace sandbox
