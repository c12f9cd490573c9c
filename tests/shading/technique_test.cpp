#include "shading/technique.h"

#include "tools/error_of.h"
#include "tools/technique_walk.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Technique, EveryCombinationIsValidAndRoundTripsOrIsRefusedWithAReason) {
    int valid = 0;
    int refused = 0;
    for_each_technique([&](const Technique &technique) {
        const auto reason = why_refused(technique);
        if (reason) {
            ++refused;
            ASSERT_FALSE(reason->empty());
        } else {
            ++valid;
            ASSERT_EQ(parse_technique(to_string(technique)), technique) << to_string(technique);
        }
    });
    EXPECT_EQ(valid + refused, 5 * 3 * 3 * 2 * 2 * 3 * 2 * 2 * 2 * 2 * 3 * 3 * 2);
    EXPECT_GT(valid, 0);
    EXPECT_GT(refused, 0);
}

TEST(Technique, DefaultsAreTheFirstOfEach) {
    EXPECT_EQ(parse_technique("per-pixel/blinn-phong"), Technique{});
    EXPECT_EQ(to_string(Technique{}), "per-pixel/blinn-phong");
    for (const auto &key : technique_keys().subspan(2)) {
        EXPECT_EQ(key.get(Technique{}), 0) << key.name;
    }
}

TEST(Technique, KeysThatCanHaveNoEffectAreRefused) {
    EXPECT_NE(error_of([] { parse_technique("per-vertex/phong:renormalize=off"); }).find("can have no effect"),
              std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/phong:half_vector=constant"); }).find("half vector"),
              std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/lambert:gate=none"); }).find("specular"), std::string::npos);
    EXPECT_NE(error_of([] {
                  parse_technique("interpolated-vectors/phong:attenuation=distance-interpolated");
              }).find("always interpolates"),
              std::string::npos);
}

TEST(Technique, WrongWordsAreNamedWithWhatWasExpected) {
    EXPECT_NE(error_of([] { parse_technique("gouraud/phong"); }).find("flat|per-vertex|per-pixel"), std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/oren"); }).find("lambert|phong|blinn-phong"), std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/phong:colour=red"); }).find("got 'colour=red'"),
              std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/phong:power="); }).find("auto|textbook|stable"),
              std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel"); }).find("FREQUENCY/MODEL"), std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/phong:power=stable,"); }), "no error");
}

TEST(Technique, NearestValidKeepsWhatApplies) {
    Technique technique = parse_technique("per-pixel/blinn-phong:renormalize=off,half_vector=constant,gate=none");
    technique.frequency = Frequency::per_vertex;
    technique.model = Model::phong;
    EXPECT_EQ(to_string(nearest_valid(technique)), "per-vertex/phong:gate=none");
}

TEST(Technique, PairwiseSelectionHoldsEveryValuePairThatIsEverValid) {
    const auto keys = technique_keys();
    std::set<std::tuple<std::size_t, int, std::size_t, int>> possible;
    std::set<std::tuple<std::size_t, int, std::size_t, int>> chosen;
    const auto add = [&](auto &set, const Technique &technique) {
        for (std::size_t i = 0; i < keys.size(); ++i) {
            for (std::size_t j = i + 1; j < keys.size(); ++j) {
                set.emplace(i, keys[i].get(technique), j, keys[j].get(technique));
            }
        }
    };
    for_each_technique([&](const Technique &technique) {
        if (!why_refused(technique)) {
            add(possible, technique);
        }
    });
    for (const Technique &technique : pairwise_techniques()) {
        add(chosen, technique);
    }
    EXPECT_EQ(chosen, possible);
}

} // namespace
} // namespace sandbox
