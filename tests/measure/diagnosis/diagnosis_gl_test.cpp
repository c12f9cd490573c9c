#include "measure/diagnosis/candidates.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "tools/diagnosed_faults.h"
#include "tools/gl_test.h"

#include <algorithm>

/// A part of the confusion table (tools/diagnosis/confusion.cpp has all of it), on the renderer.
namespace sandbox {
namespace {

constexpr Size size{160, 120};

class DiagnosisOnTheRenderer : public GlTest {
  protected:
    Renderer renderer{Assets("assets"), ShaderParts(Assets("shaders"))};
    DiagnosisDraw draw = diagnosis_drawn_by(renderer);
    [[nodiscard]] static Scene scene(const char *name) { return open_scene(name, Assets("assets")); }
};

TEST_F(DiagnosisOnTheRenderer, SingleFaultsAreNamedOrHonestlyTied) {
    ConfusionTable table;
    for (const char *name : {"three-point-lights", "box-4-normal-matrix"}) {
        for (const char *base : {"per-vertex/phong", "per-pixel/blinn-phong"}) {
            for (const FaultyPicture &picture :
                 faulty_pictures(name, scene(name), parse_technique(base), 1, draw, size)) {
                table.add(picture, diagnose({picture.scene, picture.observed, picture.base, {}, {}}, draw));
            }
        }
    }
    EXPECT_EQ(table.count(Naming::misnamed) + table.count(Naming::unknown), 0U) << table.text();
    EXPECT_GT(table.count(Naming::named), 10U) << table.text();
}

TEST_F(DiagnosisOnTheRenderer, PairsOfFaultsAreNamedOrTiedAndNeverTakenForOne) {
    ConfusionTable table;
    for (const FaultyPicture &picture : faulty_pictures("three-point-lights", scene("three-point-lights"),
                                                        parse_technique("per-pixel/phong"), 2, draw, size, 9)) {
        table.add(picture, diagnose({picture.scene, picture.observed, picture.base, {}, {}}, draw));
    }
    EXPECT_EQ(table.count(Naming::misnamed), 0U) << table.text();
    EXPECT_GE(table.count(Naming::named) + table.count(Naming::tied), 4 * table.count(Naming::unknown)) << table.text();
}

TEST_F(DiagnosisOnTheRenderer, AFaultUnderOtherLightOrWrittenOtherwiseIsNamed) {
    ConfusionTable table;
    for (const FaultyPicture &picture : unconventional_pictures("three-point-lights", scene("three-point-lights"),
                                                                parse_technique("per-pixel/phong"), draw, size, 37)) {
        table.add(picture, diagnose({picture.scene, picture.observed, picture.base, {}, {}}, draw));
    }
    EXPECT_EQ(table.count(Naming::misnamed) + table.count(Naming::unknown), 0U) << table.text();
    EXPECT_GT(table.count(Naming::named), 4U) << table.text();
}

/// Every technique with at most one fault is drawn whole, and compared.
TEST_F(DiagnosisOnTheRenderer, TiesAreExactlyThoseWithinALevel) {
    const Scene studio = scene("studio");
    const Technique base = parse_technique("per-pixel/phong");
    const auto bytes = [&](const Technique &technique) {
        return to_display(draw.picture(studio, technique, size, false).color);
    };
    const ByteImage right = bytes(base);
    const Diagnosis diagnosis = diagnose({studio, {from_bytes(size, right.rgb.data(), 3), true}, base, {}, {}}, draw);
    EXPECT_EQ(diagnosis.verdict, Verdict::right);
    EXPECT_EQ(diagnosis.technique, base);
    EXPECT_EQ(diagnosis.residual.largest, 0);
    std::size_t tied = 0;
    for (const Candidate &candidate : single_candidates(studio, draw.load(studio), {base})) {
        if (candidate.technique == base) {
            continue;
        }
        const ByteImage other = bytes(candidate.technique);
        int most = 0;
        for (std::size_t i = 0; i < other.rgb.size(); ++i) {
            most = std::max(most, std::abs(other.rgb[i] - right.rgb[i]));
        }
        const bool listed = std::ranges::find(diagnosis.ties, candidate.technique) != diagnosis.ties.end();
        EXPECT_EQ(listed, most <= 1) << to_string(candidate.technique) << " " << most;
        tied += listed ? 1 : 0;
    }
    EXPECT_GT(tied, 0U);
}

TEST_F(DiagnosisOnTheRenderer, ATieGetsASceneThatTellsIt) {
    const Scene studio = scene("studio");
    const Technique base = parse_technique("per-pixel/phong");
    const Technique tie = parse_technique("per-pixel/phong:gate=none");
    const auto proposal = propose(base, {tie}, trial_scenes(studio, "studio", Assets("assets")), draw, [] {});
    ASSERT_TRUE(proposal);
    EXPECT_EQ(proposal->told, (std::vector<Technique>{tie}));
    EXPECT_GE(proposal->levels, told_levels);
    EXPECT_FALSE(propose(base, {base}, trial_scenes(studio, "studio", Assets("assets")), draw, [] {}));
}

} // namespace
} // namespace sandbox
