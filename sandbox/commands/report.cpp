#include "commands/commands.h"

#include "commands/interrupt.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/image_file.h"
#include "image/write_guard.h"
#include "measure/report/csv.h"
#include "measure/report/report.h"
#include "measure/report/report_html.h"
#include "measure/report/report_json.h"
#include "measure/work_precision/findings.h"
#include "render/frame_clock.h"
#include "scene/read_json.h"

#include <atomic>
#include <csignal>
#include <fmt/format.h>
#include <optional>

namespace sandbox {
namespace {

struct ReportFlags {
    std::string scene, view;
    std::filesystem::path out;
    std::vector<std::string> merge;
    std::optional<Size> size;   ///< absent: the plan's own
    std::optional<int> repeats; ///< absent: the plan's own
    bool quick = false;
    std::string language{languages.front()};
};

/// The first Ctrl-C stops the measuring, and the report is written; the second ends the program at once.
std::atomic<bool> stopped{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

void stop(int) {
    stopped = true;
    handle_interrupts();
}

PlanOptions plan_options(const ReportFlags &flags) {
    PlanOptions options = flags.quick ? quick_plan() : PlanOptions{};
    options.size = flags.size.value_or(options.size);
    options.repeats = flags.repeats.value_or(options.repeats);
    return options;
}

ReportRun measure(const ReportFlags &flags, const CommonOptions &common, const PlanOptions &options,
                  const Scene &scene) {
    DrawingSession session(common);
    Target target(options.size);
    FrameClock clock(Context::software(), target, [&] { session.renderer().draw(scene, {}, target); });
    const DrawRows draw = rows_drawn_by(session.renderer(), target, clock);
    ReportRun run =
        new_report_run(session.context().renderer(), session.context().version(), std::string(clock.name()));
    run.quick = flags.quick;
    run.words = words_in(flags.language, scene_assets(common));
    ProgressBar bar("report");
    std::signal(SIGINT, stop);
    run.measured = measure_work_precision(scene, options, draw, [&](double share) {
        bar.report(share);
        return !stopped;
    });
    handle_interrupts();
    for (const OmittedRow &row : run.measured.omitted) {
        note(fmt::format("{} has no row: on this scene it is {}", row.technique, row.reason));
    }
    if (const std::size_t marked = marked_rows(run.measured); marked > 0) {
        note(fmt::format("{} of {} rows are marked: less than half of what they show is compared", marked,
                         run.measured.rows.size()));
    }
    if (run.measured.finished) {
        run.pictures = report_pictures(run.words, run.measured, draw);
    }
    return run;
}

int run_report(const ReportFlags &flags, const CommonOptions &common) {
    if (flags.scene.empty() && flags.merge.empty()) {
        throw InputError("report: expected a SCENE, or --merge with the report.json of earlier runs");
    }
    std::vector<ReportRun> runs;
    for (const std::string &file : flags.merge) {
        for (ReportRun &run : read_report_json(read_file(file, largest_json), file)) {
            runs.push_back(std::move(run));
        }
    }
    const PlanOptions options = plan_options(flags);
    std::optional<Scene> scene;
    if (!flags.scene.empty()) {
        scene = open_scene(common, flags.scene, flags.view, plan_options(flags).size);
    }
    make_folder("--out", flags.out, {"report.json", "report.csv", "report.html"}); // before the work, not after it
    if (scene) {
        runs.insert(runs.begin(), measure(flags, common, options, *scene));
    }
    for (ReportRun &run : runs) {
        run.words = words_in(flags.language, scene_assets(common));
    }
    std::error_code ignored;
    const bool beside = stopped && std::filesystem::exists(flags.out / "report.json", ignored);
    const std::string name = beside ? "report-stopped" : "report"; // what is whole stays
    write_files(std::vector<OutputFile>{{flags.out / (name + ".json"), report_json(runs)},
                                        {flags.out / (name + ".csv"), report_csv(runs)},
                                        {flags.out / (name + ".html"), report_html(runs)}});
    if (stopped) {
        note(beside ? "stopped: report-stopped.html, .json and .csv hold what was measured until then; the report that "
                      "was there stays"
                    : "stopped: the report holds what was measured until then, and says so");
        return interrupted_exit;
    }
    return 0;
}

} // namespace

void add_report_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<ReportFlags>();
    add_value(command, "SCENE", "", flags->scene, "Built-in name, or path of a .json or .obj file");
    add_value(command, "--out", "DIR", flags->out, "Folder for the three files; made if it does not exist")->required();
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size of every picture [640x480; --quick 320x240]");
    add_value(command, "--repeats", "N", flags->repeats, "Number of timed rounds [21; --quick 5]")
        ->check(CLI::Range(1, 10000));
    add_view_name(command, flags->view);
    add_language(command, flags->language, "Language of the page [en]");
    command.add_flag("--quick", flags->quick, "Overview within a minute: small pictures, ladder up to 64 rings");
    add_value(command, "--merge", "A.json B.json", flags->merge,
              "Show the runs of earlier report.json files beside this one, or,\nwithout SCENE, beside each other");
    command.footer(
        "Draws every frequency and model on a ladder of tessellations (8 to 512 rings; --quick 8 to 64) and variants\n"
        "on the scene's own meshes, judges each against the double-precision truth, and times all of them in\n"
        "turns, after 4 rounds that are dropped. A row of which less than half is compared is marked and never\n"
        "recommended. The clock is the GPU's timer if a long draw shows that it agrees with the wall clock, else the\n"
        "wall clock around draw and glFinish. Ctrl-C stops the measuring and writes what there is (exit code 130),\n"
        "beside a report that is there already as report-stopped; a second Ctrl-C ends at once.");
    run_when_chosen(command, common, run, flags, run_report);
}

} // namespace sandbox
