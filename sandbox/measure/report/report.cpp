#include "measure/report/report.h"

#include "measure/report/text.h"
#include "measure/work_precision/findings.h"
#include "words/row_words.h"

#include <cstdlib>
#include <ctime>
#include <fmt/chrono.h>
#include <fstream>
#include <thread>
#include <utility>

namespace sandbox {
namespace {

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return {};
}

std::string build_name() {
#ifdef NDEBUG
    const char *const kind = "release";
#else
    const char *const kind = "debug";
#endif
#ifdef __clang__
    return fmt::format("{}, clang {}", kind, __clang_version__);
#else
    return fmt::format("{}, gcc {}", kind, __VERSION__);
#endif
}

} // namespace

Machine this_machine() {
    const char *const llvmpipe_threads = std::getenv("LP_NUM_THREADS");
    return {.renderer = {},
            .opengl = {},
            .processor = processor_name(),
            .threads = static_cast<int>(std::thread::hardware_concurrency()),
            .llvmpipe_threads = llvmpipe_threads != nullptr ? llvmpipe_threads : "",
            .build = build_name(),
            .clock = {}};
}

ReportRun new_report_run(std::string renderer, std::string opengl, std::string clock) {
    ReportRun run;
    run.machine = this_machine();
    run.machine.renderer = std::move(renderer);
    run.machine.opengl = std::move(opengl);
    run.machine.clock = std::move(clock);
    run.version = SANDBOX_VERSION;
    run.date = fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(std::time(nullptr)));
    return run;
}

std::vector<ReportPicture> report_pictures(const Words &words, const WorkPrecision &measured, const DrawRows &draw) {
    const Model model = models_of(measured).back();
    const MeasuredRow *best = nullptr;
    const MeasuredRow *worst = nullptr;
    for (const MeasuredRow &row : measured.rows) {
        if (!is_base(row) || !row.trusted() || row.plan.technique.model != model) {
            continue;
        }
        const double error = row.errors->total.norms.rmse;
        best = best == nullptr || error < best->errors->total.norms.rmse ? &row : best;
        worst = worst == nullptr || error > worst->errors->total.norms.rmse ? &row : worst;
    }
    const bool analytic = measured.no_analytic_surface.empty();
    const ReferenceFrame truth = report_truth(model, analytic, measured.meshes, measured.options.size, draw.load);
    std::vector<ReportPicture> pictures{{words.text("report.truth"),
                                         words.format(analytic ? "report.truth_surface" : "report.truth_mesh",
                                                      title_of(words, model_key, static_cast<int>(model))),
                                         to_display(to_frame(truth).color),
                                         {}}};
    for (const auto &[title, row] : {std::pair("report.closest", best), std::pair("report.farthest", worst)}) {
        if (row != nullptr) {
            const PlannedMesh &mesh = measured.meshes[row->plan.mesh];
            pictures.push_back({words.text(title),
                                words.format("report.picture", to_string(row->plan.technique), mesh_words(words, mesh)),
                                to_display(draw.picture(mesh.scene, row->plan.technique).color),
                                "RMSE " + short_number(words, row->errors->total.norms.rmse)});
        }
    }
    return pictures;
}

} // namespace sandbox
