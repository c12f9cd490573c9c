#include "commands/commands.h"

#include "commands/interrupt.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/difference.h"
#include "image/image_file.h"
#include "measure/diagnosis/diagnosis_text.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace sandbox {
namespace {

struct DiagnoseFlags {
    std::string scene, view;
    std::filesystem::path picture, out;
    std::optional<Technique> technique;
    bool json = false;
};

/// The picture in a file, told by its first bytes.
Observed read_picture(const std::filesystem::path &path) {
    const std::string bytes = read_file(path);
    const std::string name = path.string();
    if (bytes.starts_with(png_signature)) {
        return {decode_png(bytes, name), true};
    }
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) {
        return {decode_pfm(bytes, name), false};
    }
    throw InputError("{}: expected a PNG or PFM picture, got {}", name,
                     bytes.empty() ? "an empty file" : "another kind of file");
}

/// The difference, so much stronger that its largest value has the strongest colour.
void write_residual(const DiagnoseFlags &flags, const Observed &observed, const Diagnosis &diagnosis) {
    const double largest = largest_difference(observed.numbers, diagnosis.expected);
    const double gain = largest > 0 && std::isfinite(largest) ? 1 / largest : 1;
    write_output(flags.out, encode_png(difference_picture(observed.numbers, diagnosis.expected, gain)));
    note(fmt::format("{}: picture - expected, {:.3g} times", flags.out.string(), gain));
}

int run_diagnose(const DiagnoseFlags &flags, const CommonOptions &common) {
    if (!flags.out.empty()) {
        check_output(flags.out, {".png"});
    }
    DiagnosisRequest request{
        open_scene(common, flags.scene, flags.view), read_picture(flags.picture), flags.technique, {}};
    with_flag(flags.picture.string(), [&] { check_size(request.observed.numbers.size); });
    request.trials =
        trial_scenes(request.scene, scene_arguments(common, flags.scene, flags.view), scene_assets(common));

    DrawingSession session(common);
    ProgressBar bar("diagnose");
    const auto start = std::chrono::steady_clock::now();
    const Diagnosis diagnosis = diagnose(request, diagnosis_drawn_by(session.renderer()), [&](double share) {
        bar.report(share);
        return true;
    });
    const std::string renderer = session.context().renderer();
    print(flags.json ? diagnosis_json(diagnosis, flags.scene, renderer) : diagnosis_text(diagnosis, request.scene));
    if (!flags.out.empty() && diagnosis.shown_pixels > 0) {
        write_residual(flags, request.observed, diagnosis);
    }
    if (common.verbose) {
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        note(fmt::format("{} pictures compared, {} programs built, {:.2f} s", diagnosis.candidates,
                         session.renderer().programs_built(), time.count()));
    }
    return diagnosis.verdict == Verdict::right ? 0 : 1;
}

} // namespace

void add_diagnose(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App &command =
        *app.add_subcommand("diagnose", "Say what a picture of a scene is: technique, faults, conventions");
    const auto flags = std::make_shared<DiagnoseFlags>();
    add_scene(command, flags->scene);
    add_value(command, "PICTURE", "", flags->picture,
              ".png (8 bit, as displayed) or .pfm (linear), of any program, of any size, seen by the scene's camera")
        ->required();
    add_parsed(command, "--technique", "T", flags->technique, parse_technique,
               "Frequency, model and variants that are known; faults in it are dropped [all are searched]");
    add_view_name(command, flags->view);
    command.add_flag("--json", flags->json, "Print JSON");
    add_value(command, "--out", "FILE.png", flags->out, "Write the picture less what explains it best");
    command.footer(
        "Draws what is known and compares it at every pixel that shows an object: each frequency and model with no\n"
        "fault, with one, then other ways to write numbers (sRGB, gamma 2.2, upside down), other light (a factor, a\n"
        "light or a term missing, ambient light doubled, attenuation or cones left out, other exponents), then two\n"
        "faults. An explanation differs from the picture by at most one level of 8 bits; where none does everywhere,\n"
        "outlines, edges between triangles, jumps of the equation and what rounding decides are left out, as\n"
        "`compare` leaves them out. Few faults come first; where none is needed, the picture is right. Verdicts:\n"
        "  right    no fault and no convention is needed (exit code 0; else 1)\n"
        "  named    one explanation\n"
        "  tied     several: `ties` are the others, of as few faults, that differ from `technique` by at most one\n"
        "           level at every compared pixel; a scene is proposed in which they differ\n"
        "  unknown  nothing known explains the picture; the nearest is told\n"
        "JSON: verdict, technique, ties, conventions, residual (levels), residual_rms, residual_pixels,\n"
        "compared_pixels, compared_share, masked, pixel (that shows it best, with its terms), proposal.");
    run_when_chosen(command, common, run, flags, run_diagnose);
}

} // namespace sandbox
