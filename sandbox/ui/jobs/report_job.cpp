#include "ui/jobs/report_job.h"

#include "image/error.h"
#include "reference/reference.h"
#include "render/context.h"
#include "render/frame_clock.h"
#include "words/row_words.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <vector>

namespace sandbox {

namespace {

/// Draws the same after others, and tells the job's reporter what.
DrawRows reported(const DrawRows &draw, const Words &words, DrawingTurn &turn, JobReporter &reporter) {
    DrawRows reported = draw;
    reported.picture = [&, words](const Scene &s, const Technique &t) {
        turn.let_others_draw();
        reporter.say(words.format("job.error_of", title_of(words, t)));
        return draw.picture(s, t);
    };
    reported.timed = [&, words](const Scene &s, const Technique &t) {
        turn.let_others_draw();
        reporter.say(words.format("job.time_of", title_of(words, t)));
        return draw.timed(s, t);
    };
    return reported;
}

ReportRun measure(const Scene &scene, bool quick, const DrawnBy &by, const Words &words, DrawingTurn &turn,
                  JobReporter &reporter) {
    Renderer &renderer = turn.renderer();
    const PlanOptions options = quick ? quick_plan() : PlanOptions{};
    Target target(options.size);
    FrameClock clock(Context::software(), target, [&] { renderer.draw(scene, {}, target); });
    const DrawRows draw = rows_drawn_by(renderer, target, clock);
    ReportRun run = new_report_run(by.renderer, by.opengl, std::string(clock.name()));
    run.quick = quick;
    run.words = words;
    reporter.say(words.text("job.truth"));
    run.measured = measure_work_precision(scene, options, reported(draw, words, turn, reporter),
                                          [&](double share) { return reporter.report(share); });
    if (run.measured.finished) {
        reporter.say(words.text("job.pictures"));
        run.pictures = report_pictures(words, run.measured, draw);
    }
    return run;
}

double seconds_of(const std::function<void()> &work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds that a row of a run takes: its program's, and all else. Throws InputError where it is refused, Cancelled.
struct RowCost {
    double compiling = 0, measuring = 0;
};
RowCost cost_of(const Scene &scene, const Technique &technique, const DrawRows &draw, const PlanOptions &options,
                const Progress &progress) {
    Frame drawn;
    const double first = seconds_of([&] { drawn = draw.picture(scene, technique); });
    const double again = seconds_of([&] { drawn = draw.picture(scene, technique); });
    const double frame = draw.timed(scene, technique) / 1000;
    const double judging = seconds_of([&] {
        const auto resources = draw.load(scene);
        const ReferenceFrame truth =
            render_reference(scene, resources, technique, options.size, Surface::mesh, progress);
        const ReferenceFrame other = truth;
        compare(drawn, truth, Flip::without);
        split_error(drawn, truth, other, &other);
    });
    return {std::max(first - again, 0.0), again + frame * (options.warm_ups + options.repeats) + judging};
}

/// Of the rows on each mesh a few are tried, most of them on the finest meshes, whose rows take longest.
double estimate(const Scene &scene, bool quick, DrawingTurn &turn, JobReporter &reporter) {
    Renderer &renderer = turn.renderer();
    const PlanOptions options = quick ? quick_plan() : PlanOptions{};
    Target target(options.size);
    FrameClock clock(Context::software(), target, [&] { renderer.draw(scene, {}, target); });
    const DrawRows draw = rows_drawn_by(renderer, target, clock);
    const Plan plan = plan_report(scene, options, draw.load);
    const std::size_t meshes = plan.meshes.size();
    double seconds = 0, compiling = 0, tried = 0;
    std::size_t most_rows = 0;
    for (std::size_t mesh = 0; mesh < meshes; ++mesh) {
        std::vector<PlannedRow> rows;
        std::ranges::copy_if(plan.rows, std::back_inserter(rows), [&](const PlannedRow &r) { return r.mesh == mesh; });
        const std::size_t finer = meshes - 1 - mesh;
        const std::size_t samples = std::min<std::size_t>(finer < 2 ? 3 - finer : 1, rows.size());
        double sum = 0, counted = 0;
        for (std::size_t i = 0; i < samples; ++i) {
            const std::size_t at =
                samples == 1 ? rows.size() * (2 * mesh + 1) / (2 * meshes) : rows.size() * (2 * i + 1) / (2 * samples);
            turn.let_others_draw();
            try {
                const RowCost cost = cost_of(plan.meshes[mesh].scene, rows[at].technique, draw, options,
                                             [&](double) { return !reporter.cancelled(); });
                sum += cost.measuring;
                compiling += cost.compiling;
                ++counted;
            } catch (const InputError &) {
                continue; // refused: the run, too, leaves it out
            }
        }
        tried += counted;
        seconds += counted > 0 ? sum / counted * static_cast<double>(rows.size()) : 0;
        most_rows = std::max(most_rows, rows.size());
    }
    return seconds + compiling / std::max(tried, 1.0) * static_cast<double>(most_rows); // a program once for all meshes
}

} // namespace

std::string about_seconds(const Words &words, double seconds) {
    return seconds < 100 ? words.format("error_time.seconds", std::max(std::lround(seconds / 5) * 5, 5L))
                         : words.format("error_time.minutes", std::lround(seconds / 60));
}

std::unique_ptr<CostJob> start_estimate(const DrawingSupplies &supplies, const Scene &scene, bool quick) {
    return std::make_unique<CostJob>(supplies, [scene, quick](DrawingTurn &turn, JobReporter &reporter) {
        return estimate(scene, quick, turn, reporter);
    });
}

std::unique_ptr<ReportJob> start_report(const DrawingSupplies &supplies, const Scene &scene, bool quick,
                                        const Words &words) {
    return std::make_unique<ReportJob>(
        supplies, [scene, quick, words, by = supplies.by](DrawingTurn &turn, JobReporter &reporter) {
            return measure(scene, quick, by, words, turn, reporter);
        });
}

} // namespace sandbox
