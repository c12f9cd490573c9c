#include "ui/jobs/report_job.h"

#include "image/error.h"
#include "reference/reference.h"
#include "render/context.h"
#include "render/frame_clock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace sandbox {

namespace {

/// Draws the same, and tells the job's reporter what.
DrawRows reported(const DrawRows &draw, JobReporter &reporter) {
    return {draw.load,
            [&](const Scene &s, const Technique &t) {
                reporter.say("error of " + to_string(t));
                return draw.picture(s, t);
            },
            [&](const Scene &s, const Technique &t) {
                reporter.say("run time of " + to_string(t));
                return draw.timed(s, t);
            }};
}

ReportRun measure(const Scene &scene, bool quick, const DrawnBy &by, Renderer &renderer, JobReporter &reporter) {
    const PlanOptions options = quick ? quick_plan() : PlanOptions{};
    Target target(options.size);
    FrameClock clock(Context::software(), [&] { renderer.draw(scene, {}, target); });
    const DrawRows draw = rows_drawn_by(renderer, target, clock);
    ReportRun run = new_report_run(by.renderer, by.opengl, std::string(clock.name()));
    run.quick = quick;
    reporter.say("the truth, in double precision");
    run.measured = measure_work_precision(scene, options, reported(draw, reporter),
                                          [&](double share) { return reporter.report(share); });
    if (run.measured.finished) {
        reporter.say("pictures for the report");
        run.pictures = report_pictures(run.measured, draw);
    }
    return run;
}

double ladder_meshes(const PlanOptions &options) { return 1 + std::log2(options.last_rings / options.first_rings); }

double seconds_of(const std::function<void()> &work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One row: its first picture compiles, the others cost the same.
RunCost cost_of(const Scene &scene, const Technique &technique, const DrawRows &draw, const PlanOptions &options) {
    Frame drawn;
    const double first = seconds_of([&] { drawn = draw.picture(scene, technique); });
    draw.timed(scene, technique); // warms up
    const double frame = draw.timed(scene, technique) / 1000;
    const double judged = seconds_of([&] {
        const ReferenceFrame truth =
            render_reference(scene, draw.load(scene), technique, options.size, Surface::mesh, {});
        compare(drawn, truth, Flip::without);
    });
    return {std::max(first - frame, 0.0), frame * (options.warm_ups + options.repeats + 1), judged};
}

RunCost estimate(const Scene &scene, Renderer &renderer, JobReporter &reporter) {
    constexpr std::size_t most_samples = 6;
    const PlanOptions options = quick_plan();
    Target target(options.size);
    FrameClock clock(Context::software(), [&] { renderer.draw(scene, {}, target); });
    const DrawRows draw = rows_drawn_by(renderer, target, clock);
    const Plan plan = plan_report(scene, options, draw.load);
    const std::size_t step = std::max<std::size_t>(plan.rows.size() / most_samples, 1);
    RunCost sum;
    double samples = 0;
    for (std::size_t i = step / 2; i < plan.rows.size() && !reporter.cancelled(); i += step) {
        try {
            const RunCost row = cost_of(plan.meshes[plan.rows[i].mesh].scene, plan.rows[i].technique, draw, options);
            sum = {sum.compiling + row.compiling, sum.drawing + row.drawing, sum.judging + row.judging};
            ++samples;
        } catch (const InputError &) {
            continue; // refused: the run, too, leaves it out
        }
    }
    const double rows = static_cast<double>(plan.rows.size()) / std::max(samples, 1.0);
    const double programs = rows / static_cast<double>(std::max<std::size_t>(plan.meshes.size(), 1)); // once for all
    return {sum.compiling * programs, sum.drawing * rows, sum.judging * rows};
}

} // namespace

double RunCost::seconds(bool quick) const {
    if (quick) {
        return compiling + drawing + judging;
    }
    const PlanOptions full, part = quick_plan();
    const double pixels =
        static_cast<double>(full.size.width) * full.size.height / (part.size.width * part.size.height);
    const double rounds = (full.warm_ups + full.repeats + 1.0) / (part.warm_ups + part.repeats + 1);
    const double meshes = ladder_meshes(full) / ladder_meshes(part);
    return compiling + (drawing * rounds + judging) * pixels * meshes;
}

std::string about_seconds(double seconds) {
    return seconds < 100 ? fmt::format("about {} s", std::max(std::lround(seconds / 5) * 5, 5L))
                         : fmt::format("about {} min", std::lround(seconds / 60));
}

std::unique_ptr<CostJob> start_estimate(const DrawingSupplies &supplies, const Scene &scene) {
    return std::make_unique<CostJob>(
        supplies, [scene](Renderer &renderer, JobReporter &reporter) { return estimate(scene, renderer, reporter); });
}

std::unique_ptr<ReportJob> start_report(const DrawingSupplies &supplies, const Scene &scene, bool quick) {
    return std::make_unique<ReportJob>(supplies,
                                       [scene, quick, by = supplies.by](Renderer &renderer, JobReporter &reporter) {
                                           return measure(scene, quick, by, renderer, reporter);
                                       });
}

} // namespace sandbox
