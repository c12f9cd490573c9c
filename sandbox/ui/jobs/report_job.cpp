#include "ui/jobs/report_job.h"

#include "render/context.h"
#include "render/frame_clock.h"

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

} // namespace

std::unique_ptr<ReportJob> start_report(const DrawingSupplies &supplies, const Scene &scene, bool quick) {
    return std::make_unique<ReportJob>(supplies,
                                       [scene, quick, by = supplies.by](Renderer &renderer, JobReporter &reporter) {
                                           return measure(scene, quick, by, renderer, reporter);
                                       });
}

} // namespace sandbox
