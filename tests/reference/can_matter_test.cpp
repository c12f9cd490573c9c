#include "reference/reference.h"
#include "scene/scene_file.h"
#include "shading/prepared_object.h"
#include "shading/technique.h"
#include "tools/feature_scenes.h"

#include <gtest/gtest.h>
#include <map>
#include <string>

/// can_matter() against the truth: the window says "no effect here" on its word.
namespace sandbox {
namespace {

constexpr Size size{48, 36};

std::vector<Scene> scenes() {
    std::vector<Scene> all = feature_scenes();
    for (const std::string &name : builtin_scenes(Assets("assets"))) {
        all.push_back(open_scene(name, Assets("assets")));
    }
    return all;
}

/// Calls visit(key, value, the technique with that value) for every value but the defaults of the settings that this
/// frequency and model allow.
void for_each_setting(const Technique &technique, const auto &visit) {
    for (const TechniqueKey &key : technique_settings) {
        for (int value = 1; value < static_cast<int>(key.values.size()); ++value) {
            Technique changed = technique;
            key.set(changed, value);
            if (!why_refused(changed)) {
                visit(key, value, changed);
            }
        }
    }
}

class CanMatter : public testing::Test {
  protected:
    std::vector<glm::dvec3> picture(const Scene &scene, const Technique &technique) {
        return render_reference(scene, resources_.load(scene), technique, size).color;
    }
    Resources resources_{Assets("assets")};
};

TEST_F(CanMatter, WhereAValueCannotThePictureIsTheSameToTheLastBit) {
    int no_effect = 0;
    for (const Scene &scene : scenes()) {
        for (const Frequency frequency : all_frequencies) {
            for (const Model model : all_models) {
                const Technique technique{.frequency = frequency, .model = model};
                const auto expected = picture(scene, technique);
                for_each_setting(technique, [&](const TechniqueKey &key, int value, const Technique &changed) {
                    if (!can_matter(key, value, scene, technique)) {
                        ++no_effect;
                        EXPECT_EQ(picture(scene, changed), expected) << scene.name << ", " << to_string(changed);
                    }
                });
            }
        }
    }
    EXPECT_GT(no_effect, 1000) << "the rules say no where they can";
}

TEST_F(CanMatter, TwoFaultsAtOnceAreJudgedTogether) {
    for (const Scene &scene : feature_scenes()) {
        for (const char *text :
             {"per-pixel/blinn-phong:half_vector=constant", "per-pixel/phong:viewer=infinite",
              "per-vertex/lambert:ambient=where-lit", "interpolated-vectors/blinn-phong:half_vector=constant"}) {
            const Technique technique = parse_technique(text);
            const auto expected = picture(scene, technique);
            for_each_setting(technique, [&](const TechniqueKey &key, int value, const Technique &changed) {
                if (key.get(technique) == 0 && !can_matter(key, value, scene, technique)) {
                    EXPECT_EQ(picture(scene, changed), expected) << scene.name << ", " << to_string(changed);
                }
            });
        }
    }
}

TEST_F(CanMatter, WhatCanMatterShowsInSomeSceneAndMostScenesShowSome) {
    std::map<std::string, int> shown;
    int scenes_that_show = 0, all_shown = 0, all_said = 0;
    const Technique technique;
    for (const Scene &scene : scenes()) {
        const auto expected = picture(scene, technique);
        int shown_here = 0;
        for_each_setting(technique, [&](const TechniqueKey &key, int value, const Technique &changed) {
            if (key.is_fault() && can_matter(key, value, scene, technique)) {
                ++all_said;
                const int differs = picture(scene, changed) != expected ? 1 : 0;
                shown_here += differs;
                shown[title_of(key, value)] += differs;
            }
        });
        scenes_that_show += shown_here > 0 ? 1 : 0;
        all_shown += shown_here;
    }
    EXPECT_GE(scenes_that_show, 20);
    EXPECT_GE(all_shown, 0.8 * all_said) << "what can matter does, but for what the camera does not see";
    for_each_setting(technique, [&](const TechniqueKey &key, int value, const Technique &) {
        EXPECT_TRUE(!key.is_fault() || shown[title_of(key, value)] > 0) << title_of(key, value);
    });
}

TEST_F(CanMatter, WhereAPowerCannotTheProgramsAreTheSame) {
    for (const Scene &scene : scenes()) {
        const auto resources = resources_.load(scene);
        for (const Model model : all_models) {
            const Technique technique{.model = model};
            const auto expected = object_features(scene, technique, resources);
            for_each_setting(technique, [&](const TechniqueKey &key, int value, const Technique &changed) {
                if (changed.power != Power::automatic) {
                    EXPECT_EQ(object_features(scene, changed, resources) != expected,
                              can_matter(key, value, scene, technique))
                        << scene.name << ", " << to_string(changed);
                }
            });
        }
    }
}

} // namespace
} // namespace sandbox
