#include "commands/commands.h"

#include "commands/interrupt.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "measure/drawn_by.h"

#include <memory>

namespace sandbox {
namespace {

struct StabilityFlags {
    std::filesystem::path out;
    std::string name;
    bool json = false;
};

std::vector<StabilityCase> chosen_cases(const std::string &name) {
    std::vector<StabilityCase> all = stability_cases();
    if (name.empty()) {
        return all;
    }
    for (const StabilityCase &one : all) {
        if (one.name == name) {
            return {one};
        }
    }
    throw InputError("--case: there is no case '" + name + "'; `list` names them all");
}

int run_stability(const StabilityFlags &flags, const CommonOptions &common) {
    const std::vector<StabilityCase> cases = chosen_cases(flags.name);
    std::error_code failed;
    std::filesystem::create_directories(flags.out, failed);
    if (!std::filesystem::is_directory(flags.out)) {
        throw InputError("--out: cannot make the folder '" + flags.out.string() + "'");
    }
    DrawingSession session(common);
    Target target(stability_timed_size);
    const StabilityDraw draw = cases_drawn_by(session.renderer(), target);
    StabilityRun run;
    run.renderer = session.context().renderer();
    run.version = SANDBOX_VERSION;
    ProgressBar bar("stability");
    bool passed = true;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        run.results.push_back(run_stability_case(cases[i], draw));
        passed = passed && run.results.back().passed();
        bar.report(static_cast<double>(i + 1) / static_cast<double>(cases.size()));
    }
    const std::string json = stability_json(run);
    write_output(flags.out / "stability.json", json);
    write_output(flags.out / "stability.csv", stability_csv(run));
    write_output(flags.out / "stability.html", stability_html(run));
    print(flags.json ? json : stability_table(run));
    return passed ? 0 : 1;
}

} // namespace

void add_stability(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command =
        app.add_subcommand("stability", "The stiff and extreme cases: stability.html, stability.json, stability.csv");
    auto flags = std::make_shared<StabilityFlags>();
    command->add_option("--out", flags->out, "The folder that the three files go to; made if there is none")
        ->type_name("DIR")
        ->required();
    command->add_option("--case", flags->name, "One case only; `list` names them")->type_name("NAME");
    command->add_flag("--json", flags->json, "Print the JSON instead of the table");
    command->footer("Every case is drawn as a textbook has it and as this program does, and judged against the\n"
                    "double-precision reference. Exit code 1 if a bound is broken.");
    add_common_options(*command, common);
    command->callback([flags, &common, &run] { run = [flags, &common] { return run_stability(*flags, common); }; });
}

} // namespace sandbox
