#include "shading/technique.h"

#include "tools/error_of.h"
#include "tools/technique_walk.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Technique, EveryCombinationIsValidAndRoundTripsOrIsRefusedWithAReason) {
    std::size_t valid = 0;
    std::size_t refused = 0;
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
    std::size_t combinations = 1;
    for (const TechniqueKey &key : technique_keys()) {
        combinations *= key.values.size();
    }
    EXPECT_EQ(valid + refused, combinations);
    EXPECT_GT(valid, 0U);
    EXPECT_GT(refused, 0U);
}

TEST(Technique, DefaultsAreTheFirstOfEach) {
    EXPECT_EQ(parse_technique("per-pixel/blinn-phong"), Technique{});
    EXPECT_EQ(to_string(Technique{}), "per-pixel/blinn-phong");
    for (const auto &key : technique_settings) {
        EXPECT_EQ(key.get(Technique{}), 0) << key.name;
    }
}

TEST(Technique, RowsStandBesideTheirEnumerators) {
    EXPECT_EQ(to_string({.frequency = Frequency::hybrid, .model = Model::phong}), "hybrid/phong");
    EXPECT_EQ(to_string({.normals = Normals::untransformed, .gate = Gate::none, .power = Power::stable}),
              "per-pixel/blinn-phong:normals=untransformed,gate=none,power=stable");
    EXPECT_EQ(to_string({.attenuation = AttenuationAt::distance_interpolated, .program = Program::full}),
              "per-pixel/blinn-phong:attenuation=distance-interpolated,program=full");
    EXPECT_EQ(all_frequencies.back(), Frequency::automatic);
    EXPECT_EQ(to_string({.frequency = Frequency::automatic}), "auto/blinn-phong");
    EXPECT_EQ(all_models.back(), Model::blinn_phong);
}

TEST(Technique, PeopleReadWords) {
    EXPECT_EQ(title_of(parse_technique("per-vertex/phong")), "per vertex, Phong");
    EXPECT_EQ(title_of(parse_technique("per-pixel/blinn-phong:normals=model-matrix,power=stable")),
              "per pixel, Blinn-Phong; normals: model matrix (wrong); power: stable");
    EXPECT_EQ(title_of(frequency_key, 3), "interpolated vectors");
}

TEST(Technique, KeysThatCanHaveNoEffectAreRefused) {
    EXPECT_NE(error_of([] { parse_technique("per-vertex/phong:renormalize=off"); }).find("can have no effect"),
              std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-vertex/phong:precision=medium"); }).find("light nothing there"),
              std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("flat/phong:precision=medium"); }), "no error");
    EXPECT_NE(error_of([] { parse_technique("hybrid/lambert:precision=medium"); }), "no error");
    EXPECT_NE(error_of([] { parse_technique("per-pixel/phong:precision=medium,program=full"); }).find("program=full"),
              std::string::npos);
    EXPECT_EQ(to_string(parse_technique("hybrid/phong:precision=medium")), "hybrid/phong:precision=medium");
    EXPECT_NE(error_of([] { parse_technique("per-pixel/phong:half_vector=constant"); }).find("half vector"),
              std::string::npos);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/lambert:gate=none"); }).find("specular"), std::string::npos);
    EXPECT_NE(error_of([] {
                  parse_technique("interpolated-vectors/phong:attenuation=distance-interpolated");
              }).find("always interpolates"),
              std::string::npos);
}

TEST(Technique, ToleranceIsANumberOfAutoAlone) {
    const Technique technique = parse_technique("auto/phong:tolerance=0.01,gate=none");
    EXPECT_EQ(technique.tolerance, 0.01);
    EXPECT_EQ(to_string(technique), "auto/phong:tolerance=0.01,gate=none");
    EXPECT_EQ(title_of(technique), "automatic, Phong; tolerance 0.01; specular gate: none (wrong)");
    EXPECT_EQ(parse_technique("auto/phong").tolerance, default_tolerance);
    EXPECT_EQ(parse_technique(to_string({.frequency = Frequency::automatic, .tolerance = 1.0 / 3})).tolerance, 1.0 / 3);
    EXPECT_NE(error_of([] { parse_technique("per-pixel/phong:tolerance=0.01"); }).find("frequency auto"),
              std::string::npos);
    for (const char *wrong : {"0", "-1", "1.5", "nan", "inf", "", "0.1x"}) {
        EXPECT_NE(error_of([&] {
                      parse_technique(std::string("auto/phong:tolerance=") + wrong);
                  }).find("tolerance: expected a number above 0 and at most 1"),
                  std::string::npos)
            << wrong;
    }
    Technique other = technique;
    other.frequency = Frequency::per_pixel;
    EXPECT_EQ(to_string(nearest_valid(other)), "per-pixel/phong:gate=none");
}

TEST(Technique, AutoHasTwoParts) {
    const Technique technique = parse_technique("auto/phong:tolerance=0.01,renormalize=off,gate=none");
    EXPECT_EQ(to_string(part_of_auto(technique, Frequency::per_vertex)), "per-vertex/phong:gate=none");
    EXPECT_EQ(to_string(part_of_auto(technique, Frequency::per_pixel)), "per-pixel/phong:renormalize=off,gate=none");
    EXPECT_EQ(part_of_auto(Technique{}, Frequency::per_vertex), Technique{});
}

TEST(Technique, WrongWordsAreNamedWithWhatWasExpected) {
    EXPECT_NE(error_of([] { parse_technique("gouraud/phong"); }).find("flat|per-vertex|per-pixel"), std::string::npos);
    const std::string unknown_model = error_of([] { parse_technique("per-pixel/oren"); });
    EXPECT_NE(unknown_model.find("model: expected lambert|phong|"), std::string::npos) << unknown_model;
    EXPECT_NE(unknown_model.find("|blinn-phong|own, got 'oren'"), std::string::npos) << unknown_model;
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
