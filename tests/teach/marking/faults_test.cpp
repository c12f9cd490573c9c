#include "teach/marking/marking_fakes.h"
#include "teach/marking/naming.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

namespace sandbox {
namespace {

/// Each line changes the textbook's text of some model, the change is accepted as own shading, and both languages have
/// a sentence for it.
TEST(WrongLines, AreLinesOfTheTextbook) {
    const ShaderParts parts{Assets("shaders")};
    for (const WrongLine &line : wrong_lines()) {
        bool found = false;
        for (const Model model : all_models) {
            Exercise exercise;
            exercise.target.model = model;
            const auto text = wrong_text(line, exercise, parts);
            found = found || text.has_value();
        }
        EXPECT_TRUE(found) << line.id << ": no model's text has the line: " << line.from;
        for (const std::string_view language : languages) {
            EXPECT_NE(words_in(language).find(fmt::format("mark.fault.{}", line.id)), nullptr)
                << language << " " << line.id;
        }
    }
}

TEST(NamedFaults, CostATermThatIsAskedFor) {
    const Assets assets("assets");
    for (const Exercise &exercise : builtin_exercises(assets, english)) {
        for (int i = 0; i < static_cast<int>(std::size(technique_settings)); ++i) {
            for (int value = 1; value < static_cast<int>(technique_settings[i].values.size()); ++value) {
                Technique technique = exercise.target;
                technique_settings[i].set(technique, value);
                const auto faults = faults_of(technique, {}, exercise);
                EXPECT_EQ(faults.size(),
                          technique_settings[i].is_fault() || technique_settings[i].name == "normalisation" ? 1U : 0U)
                    << technique_settings[i].name << " " << value;
                for (const Fault &fault : faults) {
                    EXPECT_NE(exercise.find(fault.term), nullptr) << exercise.name;
                }
            }
        }
    }
}

TEST(NamedFaults, ConventionsHaveSentences) {
    const Exercise exercise = small_exercise(R"([{"term": "ambient"}, {"term": "diffuse"}, {"term": "attenuation"}])");
    const auto fault = [&](const std::string &name) {
        return faults_of(exercise.target, {{name, ""}}, exercise).at(0);
    };
    for (const char *name : {"display=srgb", "display=gamma-2.2", "flipped", "clamped", "factor=0.5", "lights[1]=0",
                             "attenuation=none", "cone=none", "ambient=attenuated", "ambient=2", "ambient=0",
                             "diffuse=0.5", "specular=3", "exponent=0.5", "a new one"}) {
        EXPECT_NE(english.find(fault(name).key), nullptr) << name << ": " << fault(name).key;
        EXPECT_NE(exercise.find(fault(name).term), nullptr) << name;
    }
    EXPECT_EQ(fault("ambient=2").value, "2");
    EXPECT_EQ(fault("ambient=2").term, MarkTerm::ambient);
    EXPECT_EQ(fault("ambient=0").key, "mark.fault.ambient-missing");
    EXPECT_EQ(fault("attenuation=none").term, MarkTerm::attenuation);
    EXPECT_EQ(fault("cone=none").term, MarkTerm::diffuse) << "cones are not asked for";
}

TEST(ErrorKinds, AreTakenFromPictures) {
    std::vector<glm::vec3> truth;
    for (int i = 0; i < 100; ++i) {
        truth.emplace_back(0.005F * static_cast<float>(std::max(0, i - 40)));
    }
    const auto kind = [&](const std::function<glm::vec3(glm::vec3, int)> &change) {
        std::vector<glm::vec3> answer;
        for (int i = 0; i < 100; ++i) {
            answer.push_back(change(truth[static_cast<std::size_t>(i)], i));
        }
        return kind_of(answer, truth, 1.0 / 255);
    };
    EXPECT_EQ(kind([](glm::vec3, int) { return glm::vec3(0); }), ErrorKind::missing);
    EXPECT_EQ(kind([](glm::vec3 v, int) { return -v; }), ErrorKind::negative);
    EXPECT_EQ(kind([](glm::vec3 v, int) { return 2.0F * v; }), ErrorKind::too_bright);
    EXPECT_EQ(kind([](glm::vec3 v, int) { return 0.5F * v; }), ErrorKind::too_dark);
    EXPECT_EQ(kind([](glm::vec3 v, int) { return v * glm::vec3(1, 0.5, 0.2); }), ErrorKind::color);
    EXPECT_EQ(kind([](glm::vec3 v, int i) { return v + glm::vec3(i < 30 ? 0.2F : 0.0F); }), ErrorKind::unlit_too);
    EXPECT_EQ(kind([](glm::vec3, int) { return glm::vec3(0.2F); }), ErrorKind::everywhere);
    EXPECT_EQ(kind([](glm::vec3, int i) { return glm::vec3(i < 40 ? 0.003F * static_cast<float>(40 - i) : 0.0F); }),
              ErrorKind::elsewhere);
    EXPECT_EQ(kind([](glm::vec3 v, int i) { return i > 90 ? v : glm::vec3(0); }), ErrorKind::too_narrow);
    EXPECT_EQ(kind([](glm::vec3 v, int i) { return i == 3 ? glm::vec3(NAN) : v; }), ErrorKind::not_finite);
}

} // namespace
} // namespace sandbox
