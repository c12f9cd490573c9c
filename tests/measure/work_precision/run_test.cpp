#include "measure/work_precision/run.h"

#include "image/error.h"
#include "measure/work_precision/findings.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <set>

namespace sandbox {
namespace {

Scene ball_scene() {
    Scene scene;
    scene.name = "Ball";
    Light light;
    light.position = {1, 2, 3};
    light.attenuation = {0.5, 0.1, 0.1};
    scene.lights = {light};
    scene.objects = {{"ball", SphereShape{1, 16, 32}, {}, {}, false}};
    return scene;
}

PlanOptions small_plan() { return {{16, 12}, 8, 32, 4, 5}; }

std::vector<ObjectResources> load(const Scene &scene) {
    std::vector<ObjectResources> resources;
    for (const Object &object : scene.objects) {
        resources.push_back({std::make_shared<const Mesh>(build_mesh(object.mesh)), nullptr});
    }
    return resources;
}

int rings_of(const Scene &scene) { return std::get<SphereShape>(scene.objects[0].mesh).rings; }
std::string key_of(const Scene &scene, const Technique &technique) {
    return std::to_string(rings_of(scene)) + " " + to_string(technique);
}

/// The double picture rounded to float32, and times that are 1, 2, 3, ... ms a call of the same row.
struct FakeRenderer {
    std::vector<std::string> timed;
    std::map<std::string, int> calls;
    std::string refuses;
    std::shared_ptr<const int> programs = std::make_shared<const int>();
    std::set<long> holders; ///< of the programs, in timed frames

    DrawRows draw() {
        return {load,
                [this](const Scene &scene, const Technique &technique) {
                    if (to_string(technique) == refuses) {
                        throw InputError("needs 68 varying components of 60");
                    }
                    return to_frame(render_reference(scene, load(scene), technique, small_plan().size));
                },
                [this](const Scene &scene, const Technique &technique) {
                    timed.push_back(key_of(scene, technique));
                    holders.insert(programs.use_count());
                    return static_cast<double>(++calls[timed.back()]);
                },
                {},
                [this] { return programs; }};
    }
};

/// A program that had to make room between two turns would be built inside a frame's time.
TEST(WorkPrecision, EveryProgramStaysWhileFramesAreTimed) {
    FakeRenderer fake;
    measure_work_precision(ball_scene(), small_plan(), fake.draw());
    EXPECT_EQ(fake.holders, std::set<long>{2});
    EXPECT_EQ(fake.programs.use_count(), 1);
}

TEST(WorkPrecision, AFewTechniquesAloneAndNoTimes) {
    FakeRenderer fake;
    PlanOptions plan = small_plan();
    plan.only = {parse_technique("per-vertex/phong"), parse_technique("per-pixel/phong")};
    plan.warm_ups = plan.repeats = 0;
    const WorkPrecision measured = measure_work_precision(ball_scene(), plan, fake.draw());
    EXPECT_TRUE(measured.finished);
    EXPECT_TRUE(fake.timed.empty());
    ASSERT_EQ(measured.rows.size(), 6U) << "two on three rungs, and no variants";
    for (const MeasuredRow &row : measured.rows) {
        EXPECT_TRUE(row.errors && !row.time);
        EXPECT_EQ(row.plan.group, RowGroup::ladder);
        EXPECT_EQ(row.plan.technique.model, Model::phong);
    }
}

TEST(WorkPrecision, RowsTakeTurnsAndWarmUpsAreDropped) {
    FakeRenderer fake;
    const WorkPrecision measured = measure_work_precision(ball_scene(), small_plan(), fake.draw());
    const std::size_t rows = measured.rows.size();
    ASSERT_GT(rows, 45U); // 14 techniques on 3 rungs, and the variants
    ASSERT_EQ(fake.timed.size(), rows * 9);
    for (std::size_t i = rows; i < fake.timed.size(); ++i) {
        ASSERT_EQ(fake.timed[i], fake.timed[i - rows]) << "every round has the same order";
    }
    std::vector<std::string> round(fake.timed.begin(), fake.timed.begin() + static_cast<std::ptrdiff_t>(rows));
    std::ranges::sort(round);
    EXPECT_EQ(std::ranges::adjacent_find(round), round.end()) << "every row once a round";
    for (const MeasuredRow &row : measured.rows) {
        ASSERT_TRUE(row.complete());
        EXPECT_EQ(row.time->samples, (std::vector<double>{5, 6, 7, 8, 9})) << "the first four are warm-ups";
        EXPECT_EQ(row.time->min, 5);
        EXPECT_EQ(row.time->median, 7);
        EXPECT_EQ(row.time->lower_quartile, 6);
        EXPECT_EQ(row.time->upper_quartile, 8);
    }
    EXPECT_TRUE(measured.finished);
    EXPECT_TRUE(measured.no_analytic_surface.empty());
}

TEST(WorkPrecision, QuartilesBetweenSamples) {
    const RunTime time = run_time({4, 1, 3, 2});
    EXPECT_EQ(time.samples, (std::vector<double>{4, 1, 3, 2})) << "in the order of the rounds";
    EXPECT_EQ(time.min, 1);
    EXPECT_EQ(time.lower_quartile, 1.75);
    EXPECT_EQ(time.median, 2.5);
    EXPECT_EQ(time.upper_quartile, 3.25);
    EXPECT_EQ(run_time({7}).median, 7);
    EXPECT_THROW(run_time({}), std::invalid_argument);
}

TEST(WorkPrecision, ErrorsAreTheSameToTheLastDigit) {
    FakeRenderer one, other;
    const WorkPrecision a = measure_work_precision(ball_scene(), small_plan(), one.draw());
    const WorkPrecision b = measure_work_precision(ball_scene(), small_plan(), other.draw());
    ASSERT_EQ(a.rows.size(), b.rows.size());
    for (std::size_t i = 0; i < a.rows.size(); ++i) {
        EXPECT_EQ(a.rows[i].errors->total.norms.rmse, b.rows[i].errors->total.norms.rmse);
        EXPECT_EQ(a.rows[i].errors->total.norms.max_abs, b.rows[i].errors->total.norms.max_abs);
        EXPECT_EQ(a.rows[i].errors->split.geometry->rmse, b.rows[i].errors->split.geometry->rmse);
    }
}

TEST(WorkPrecision, TheSplitTellsCausesApart) {
    FakeRenderer fake;
    const WorkPrecision measured = measure_work_precision(ball_scene(), small_plan(), fake.draw());
    for (const MeasuredRow &row : measured.rows) {
        const ErrorSplit &split = row.errors->split;
        const Technique &t = row.plan.technique;
        EXPECT_EQ(split.arithmetic.max_abs < 2e-7, row.plan.group != RowGroup::precision)
            << "the fake rounds to float32 and does nothing else, but for rows in half" << to_string(t);
        EXPECT_GT(split.geometry->rmse, 0) << "no mesh is the ball";
        EXPECT_EQ(row.certificate.has_value(), t.frequency == Frequency::automatic);
        if (row.certificate) {
            EXPECT_LE(split.interpolation.max_abs, row.certificate->bound) << to_string(t);
            EXPECT_LE(row.certificate->bound, t.tolerance) << to_string(t);
            continue; // on a coarse ball nothing is proved, and nothing interpolated
        }
        const bool exact = t.frequency == Frequency::per_pixel && row.plan.group != RowGroup::claim;
        EXPECT_EQ(split.interpolation.rmse == 0, exact) << to_string(t);
    }
}

TEST(WorkPrecision, ARefusedRowIsKeptWithItsReason) {
    FakeRenderer fake;
    fake.refuses = "interpolated-vectors/phong";
    const WorkPrecision measured = measure_work_precision(ball_scene(), small_plan(), fake.draw());
    int refused = 0;
    for (const MeasuredRow &row : measured.rows) {
        if (to_string(row.plan.technique) == fake.refuses) {
            ++refused;
            EXPECT_EQ(row.refused, "needs 68 varying components of 60");
            EXPECT_FALSE(row.errors || row.time);
        }
    }
    EXPECT_EQ(refused, 3);
    EXPECT_TRUE(measured.finished);
    EXPECT_TRUE(std::ranges::none_of(
        fake.timed, [](const std::string &key) { return key.ends_with("interpolated-vectors/phong"); }));
}

TEST(WorkPrecision, StoppedWorkKeepsWhatWasMeasured) {
    for (const double stop_at : {0.2, 0.8}) {
        FakeRenderer fake;
        const WorkPrecision measured = measure_work_precision(ball_scene(), small_plan(), fake.draw(),
                                                              [&](double share) { return share < stop_at; });
        EXPECT_FALSE(measured.finished);
        const auto judged =
            std::ranges::count_if(measured.rows, [](const auto &row) { return row.errors.has_value(); });
        const auto timed = std::ranges::count_if(measured.rows, [](const auto &row) { return row.time.has_value(); });
        const auto all = static_cast<std::ptrdiff_t>(measured.rows.size());
        if (stop_at < 0.4) {
            EXPECT_GT(judged, 0);
            EXPECT_LT(judged, all);
            EXPECT_EQ(timed, 0);
        } else {
            EXPECT_EQ(judged, all);
            EXPECT_EQ(timed, all);
            EXPECT_LT(measured.rows.back().time->samples.size(), 5U);
        }
    }
}

TEST(WorkPrecision, ProgressNeverGoesBack) {
    FakeRenderer fake;
    double last = 0;
    bool back = false;
    measure_work_precision(ball_scene(), small_plan(), fake.draw(), [&](double share) {
        back = back || share < last || share > 1;
        last = share;
        return true;
    });
    EXPECT_FALSE(back);
    EXPECT_GT(last, 0.99);
}

TEST(WorkPrecisionPlan, TheLadderHalvesEveryTriangle) {
    Scene scene = ball_scene();
    scene.objects.push_back({"floor", PlaneShape{{4, 4}, 3}, {}, {}, false});
    scene.objects.push_back({"ring", TorusShape{1, 0.4, 48, 24}, {}, {}, false});
    const Scene coarse = with_rings(scene, 8, 8);
    const Scene fine = with_rings(scene, 32, 8);
    EXPECT_EQ(std::get<SphereShape>(coarse.objects[0].mesh), (SphereShape{1, 8, 16}));
    EXPECT_EQ(std::get<SphereShape>(fine.objects[0].mesh), (SphereShape{1, 32, 64}));
    EXPECT_EQ(std::get<PlaneShape>(coarse.objects[1].mesh).divisions, 2); // 1.5 rounded
    EXPECT_EQ(std::get<PlaneShape>(fine.objects[1].mesh).divisions, 8);
    EXPECT_EQ(std::get<TorusShape>(coarse.objects[2].mesh), (TorusShape{1, 0.4, 24, 12}));
    EXPECT_EQ(std::get<TorusShape>(fine.objects[2].mesh), (TorusShape{1, 0.4, 96, 48}));
}

TEST(WorkPrecisionPlan, TheOwnMeshIsARungOrARowOfItsOwn) {
    const Plan rung = plan_report(ball_scene(), small_plan(), load);
    ASSERT_EQ(rung.meshes.size(), 3U);
    EXPECT_TRUE(rung.meshes[1].own && rung.meshes[1].ladder);
    EXPECT_EQ(rung.meshes[1].triangles, load(ball_scene())[0].mesh->triangles.size());
    Scene between = ball_scene();
    between.objects[0].mesh = SphereShape{1, 20, 41};
    const Plan own = plan_report(between, small_plan(), load);
    ASSERT_EQ(own.meshes.size(), 4U);
    EXPECT_TRUE(own.meshes[0].own && !own.meshes[0].ladder);
    EXPECT_TRUE(std::ranges::none_of(own.rows, [&](const PlannedRow &row) {
        return row.group != RowGroup::ladder && row.mesh != 0;
    })) << "variants are measured on the own mesh alone";
}

TEST(WorkPrecisionPlan, RowsWithTheSameProgramAreLeftOutAndNamed) {
    Scene matt = ball_scene();
    matt.objects[0].material.specular = glm::dvec3(0);
    const Plan plan = plan_report(matt, small_plan(), load);
    EXPECT_TRUE(
        std::ranges::all_of(plan.rows, [](const PlannedRow &row) { return row.technique.model == Model::lambert; }));
    const auto omitted = std::ranges::find(plan.omitted, "per-pixel/phong", &OmittedRow::technique);
    ASSERT_NE(omitted, plan.omitted.end());
    EXPECT_EQ(omitted->reason, "the same program as per-pixel/lambert");
}

} // namespace
} // namespace sandbox
