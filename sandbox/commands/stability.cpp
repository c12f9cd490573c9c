#include "commands/commands.h"

#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/write_files.h"
#include "measure/report/stability_report.h"

namespace sandbox {
namespace {

struct StabilityFlags {
    std::filesystem::path out;
    std::string chosen; ///< --case; empty: all
    std::string language{languages.front()};
    bool json = false;
};

int run_stability(const StabilityFlags &flags, const CommonOptions &common) {
    refuse_settings(common, "a case brings its own scene");
    const Assets assets = scene_assets(common);
    const auto cases = with_flag("--case", [&] {
        return flags.chosen.empty() ? stability_cases(assets)
                                    : std::vector<StabilityCase>{open_stability_case(flags.chosen, assets)};
    });
    if (cases.empty()) {
        throw InputError("--assets: expected cases in {}, found none", (assets.folder() / "stability/cases").string());
    }
    make_folder("--out", flags.out, {"stability.json", "stability.csv", "stability.html"});
    DrawingSession session(common);
    Target target(stability_timed_size);
    const StabilityDraw draw = cases_drawn_by(session.renderer(), target);
    StabilityRun run;
    run.renderer = session.context().renderer();
    run.version = SANDBOX_VERSION;
    run.words = words_in(flags.language, assets);
    ProgressBar bar("stability");
    bool passed = true;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        run.results.push_back(run_stability_case(cases[i], draw));
        passed = passed && run.results.back().passed();
        bar.report(static_cast<double>(i + 1) / static_cast<double>(cases.size()));
    }
    const std::string json = stability_json(run);
    write_files(std::vector<OutputFile>{{flags.out / "stability.json", json},
                                        {flags.out / "stability.csv", stability_csv(run)},
                                        {flags.out / "stability.html", stability_html(run)}});
    print(flags.json ? json : stability_table(run));
    return passed ? 0 : 1;
}

} // namespace

void add_stability_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<StabilityFlags>();
    add_value(command, "--out", "DIR", flags->out, "Folder for the three files; made if it does not exist")->required();
    add_value(command, "--case", "NAME|FILE.json", flags->chosen,
              "Only this built-in case (see: list), or the case in a file");
    add_language(command, flags->language, "Language of the page [en]");
    command.add_flag("--json", flags->json, "Print the JSON instead of the table");
    command.footer(
        "Draws every case in the textbook's form and in this program's, and judges both against the\n"
        "double-precision reference. Exit code 1 if this program breaks a bound. A case is a JSON file such as\n"
        "  {\"group\": \"spot\", \"symptom\": \"...\", \"cause\": \"...\", \"source\": \"...\",\n"
        "   \"scene\": \"spot-light\", \"set\": [\"lights[0].cutoff_degrees=0.1\"], \"bound\": 0.004}\n"
        "with, if need be, techniques, textbook (a technique that shows the damage; float32 on the processor\n"
        "without one), textbook_target (\"half\": kept in half floats), unit (\"brightest value\") and seen_on:\n"
        "where the damage was seen. Cases in which nothing breaks on this renderer stand in a list of their own.");
    run_when_chosen(command, common, run, flags, run_stability);
}

} // namespace sandbox
