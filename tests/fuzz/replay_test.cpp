#include "fuzz/json_mutator.h"
#include "fuzz/target.h"

#include <gtest/gtest.h>
#include <ostream>
#include <random>
#include <set>

/// What fuzzers begin with and what they once found, without a fuzzer.
namespace sandbox {

/// In the names of tests.
static void PrintTo(const FuzzTarget &target, std::ostream *out) { *out << target.name; }

namespace {

class FuzzTargets : public testing::TestWithParam<FuzzTarget> {};

TEST_P(FuzzTargets, HoldForTheirSeeds) {
    const std::vector<std::string> seeds = GetParam().seeds();
    EXPECT_FALSE(seeds.empty());
    for (const std::string &seed : seeds) {
        EXPECT_NO_THROW(GetParam().check(seed)) << seed.substr(0, 1000);
    }
}

TEST_P(FuzzTargets, HoldForWhatOnceBrokeThem) {
    for (const std::string &input : kept_inputs("regressions", GetParam().name)) {
        EXPECT_NO_THROW(GetParam().check(input)) << input.substr(0, 1000);
    }
}

/// A few hundred changes of the seeds: what breaks at once is seen by every test run.
TEST_P(FuzzTargets, HoldForSeedsThatWereChanged) {
    const std::vector<std::string> seeds = GetParam().seeds();
    const JsonMutator mutator(seeds);
    constexpr unsigned changes = 300;
    for (unsigned i = 0; i < changes; ++i) {
        std::string text = seeds[i % seeds.size()];
        if (auto changed = GetParam().json ? mutator.changed(text, i, text.size() * 2) : std::nullopt) {
            text = std::move(*changed);
        } else {
            std::minstd_rand dice(i);
            text[dice() / 7 % text.size()] = static_cast<char>(dice() / 7 % 256);
        }
        EXPECT_NO_THROW(GetParam().check(text)) << text.substr(0, 1000);
    }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, FuzzTargets, testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto &info) { return std::string(info.param.name); });

TEST(JsonMutator, MakesOtherJsonWithTheKeysOfItsSeeds) {
    const std::vector<std::string> seeds{R"({"lights": [{"type": "point", "diffuse": 0.5}]})", R"({"name": "a"})"};
    const JsonMutator mutator(seeds);
    std::set<std::string> made;
    bool learnt = false;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const auto text = mutator.changed(seeds[0], seed, 10000);
        if (text) {
            EXPECT_TRUE(nlohmann::json::accept(*text)) << *text;
            learnt = learnt || text->find("\"name\":") != std::string::npos;
            made.insert(*text);
        }
    }
    EXPECT_GT(made.size(), 100U);
    EXPECT_TRUE(learnt);
    EXPECT_EQ(mutator.changed("{", 1, 100), std::nullopt);
    EXPECT_EQ(mutator.crossed(R"({"a": 1})", R"({"a": 2})", 3, 1), std::nullopt) << "too long";
}

} // namespace
} // namespace sandbox
