#include "tools/english.h"
#include "ui/jobs/measured_rows.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

Technique technique_of(Frequency frequency, Model model) {
    Technique technique;
    technique.frequency = frequency;
    technique.model = model;
    return technique;
}

Scene ball(int rings) {
    Scene scene;
    scene.lights.resize(1);
    scene.objects = {{"ball", SphereShape{1, rings, 2 * rings}, {}, {}, false}};
    return scene;
}

/// Two techniques on two meshes, the finer one being the scene's own; three timed rounds.
WorkPrecision measured_ball() {
    WorkPrecision m;
    m.scene = ball(16);
    m.options.repeats = 3;
    m.meshes = {{8, false, true, 200, ball(8)}, {16, true, true, 900, ball(16)}};
    for (const std::size_t mesh : {0U, 1U}) {
        for (const Frequency frequency : {Frequency::per_vertex, Frequency::per_pixel}) {
            MeasuredRow row;
            row.plan = {mesh, technique_of(frequency, Model::phong), RowGroup::ladder};
            row.errors = RowErrors{};
            row.time = run_time({1, 2, 3});
            m.rows.push_back(row);
        }
    }
    return m;
}

Document document_with(const Scene &scene) {
    return document_of("ball", scene, technique_of(Frequency::flat, Model::lambert),
                       technique_of(Frequency::per_pixel, Model::phong));
}

TEST(MeasuredRows, EveryMeasuredMeshIsCurrent) {
    const WorkPrecision m = measured_ball();
    EXPECT_TRUE(is_current(m, ball(16)));
    EXPECT_TRUE(is_current(m, ball(8))) << "a rung of the ladder was measured too";
    EXPECT_FALSE(is_current(m, ball(9)));
}

TEST(MeasuredRows, AnyOtherEditMakesThemStale) {
    const WorkPrecision m = measured_ball();
    Scene edited = ball(16);
    edited.lights[0].diffuse = 0.5;
    EXPECT_FALSE(is_current(m, edited));
    edited = ball(16);
    edited.camera.position.x += 1;
    EXPECT_FALSE(is_current(m, edited)) << "another view has other pixels";
}

TEST(MeasuredRows, AClickTakesTechniqueAndMesh) {
    const WorkPrecision m = measured_ball();
    Document document = document_with(ball(16));
    const Technique right = document.right;
    take_row(document, m, 0, false);
    EXPECT_EQ(document.left, technique_of(Frequency::per_vertex, Model::phong));
    EXPECT_EQ(document.right, right);
    EXPECT_EQ(document.scene, ball(8));
    take_row(document, m, 2, true);
    EXPECT_EQ(document.right, technique_of(Frequency::per_vertex, Model::phong));
    EXPECT_EQ(document.scene, ball(16)) << "the own mesh is one click away, too";
}

TEST(MeasuredRows, AClickOnStaleRowsKeepsTheEdits) {
    const WorkPrecision m = measured_ball();
    Scene edited = ball(16);
    edited.lights[0].diffuse = 0.5;
    Document document = document_with(edited);
    take_row(document, m, 0, false);
    EXPECT_EQ(document.left, technique_of(Frequency::per_vertex, Model::phong));
    EXPECT_EQ(document.scene, edited);
}

TEST(MeasuredRows, ShownAreThoseOfThisMesh) {
    const WorkPrecision m = measured_ball();
    EXPECT_EQ(shown_row(m, document_with(ball(16)), true), 3U);
    EXPECT_EQ(shown_row(m, document_with(ball(8)), true), 1U);
    EXPECT_FALSE(shown_row(m, document_with(ball(16)), false)) << "flat lambert was not measured";
    EXPECT_FALSE(shown_row(m, document_with(ball(9)), true)) << "stale";
    Document other = document_with(ball(16));
    other.right.model = Model::blinn_phong;
    EXPECT_FALSE(shown_row(m, other, true));
    EXPECT_EQ(shown_row(m, other, true, Model::phong), 3U) << "the same technique under the plotted model";
}

TEST(MeasuredRows, WhatIsClickedIsShown) {
    const WorkPrecision m = measured_ball();
    for (std::size_t row = 0; row < m.rows.size(); ++row) {
        for (const bool right : {false, true}) {
            Document document = document_with(ball(16));
            take_row(document, m, row, right);
            EXPECT_EQ(shown_row(m, document, right), row);
        }
    }
}

TEST(MeasuredRows, StoppedRunsHaveFewerRowsAndRounds) {
    WorkPrecision m = measured_ball();
    EXPECT_EQ(complete_rows(m), 4U);
    EXPECT_EQ(complete_rounds(m), 3U);
    m.rows[2].time = run_time({1, 2});
    EXPECT_EQ(complete_rounds(m), 2U);
    m.rows[3].time.reset();
    EXPECT_EQ(complete_rows(m), 3U);
    EXPECT_EQ(complete_rounds(m), 0U);
    m.rows[3].refused = "too many varyings";
    EXPECT_EQ(complete_rounds(m), 2U) << "what cannot be drawn has no rounds to wait for";
}

TEST(MeasuredRows, TellWhatTheyAre) {
    WorkPrecision m = measured_ball();
    m.rows[1].errors->total.norms.rmse = 0.0125;
    m.rows[1].errors->split.interpolation.rmse = 0.011;
    const std::vector<std::string> lines = row_lines(english, m, 1);
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[0], "per-pixel/phong");
    EXPECT_EQ(lines[1], "8 rings, 200 triangles");
    EXPECT_NE(lines[2].find("2.00 ms"), std::string::npos) << lines[2];
    EXPECT_NE(lines[3].find("RMSE 0.0125"), std::string::npos) << lines[3];
    EXPECT_NE(lines[4].find("interpolation 0.0110"), std::string::npos) << lines[4];
    m.rows[1].time.reset();
    EXPECT_EQ(row_lines(english, m, 1).size(), 5U);
}

} // namespace
} // namespace sandbox
