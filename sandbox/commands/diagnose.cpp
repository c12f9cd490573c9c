#include "commands/commands.h"

#include "commands/own_flags.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "image/difference.h"
#include "image/image_file.h"
#include "image/picture_size.h"
#include "measure/diagnosis/diagnosis_text.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <functional>
#include <optional>

namespace sandbox {
namespace {

struct DiagnoseFlags {
    std::string scene, view, technique, own;
    std::filesystem::path picture, out;
    std::optional<Size> size;
    bool json = false;
};

/// Draws own text, which strangers write: apart from what draws the techniques it is held against. Of that size; the
/// last argument: with object ids. Throws InputError where the text does not compile.
using OwnDraw = std::function<Frame(const Scene &, const Technique &, Size, bool)>;

/// The difference, so much stronger that its largest value has the strongest colour.
void write_residual(const DiagnoseFlags &flags, const Observed &observed, const Diagnosis &diagnosis) {
    const double largest = largest_difference(observed.numbers, diagnosis.expected);
    const double gain = largest > 0 && std::isfinite(largest) ? 1 / largest : 1;
    write_file(flags.out, encode_png(difference_picture(observed.numbers, diagnosis.expected, gain)));
    note(fmt::format("{}: picture - expected, {:.3g} times", flags.out.string(), gain));
}

/// --technique; of own shading without one, where it is drawn.
std::optional<Technique> known_technique(const DiagnoseFlags &flags, const OwnShader &own) {
    const std::string text = !flags.technique.empty() ? flags.technique : own ? "per-pixel/own" : "";
    if (text.empty()) {
        return std::nullopt;
    }
    return with_flag("--technique", [&] { return parse_technique_with(own, text); });
}

/// Has `request` drawn from own shading.
void draw_observed(DiagnosisRequest &request, const OwnShader &own, Size size, const OwnDraw &draw) {
    const Technique technique{.frequency = request.technique->frequency, .model = Model::own, .own = own};
    if (const auto why = why_refused(technique)) {
        throw InputError("--technique: {}", *why);
    }
    request.redraw = [=](const Scene &scene) { return Observed{draw(scene, technique, size, false).color, false}; };
    request.observed = request.redraw(request.scene);
}

int run_diagnose(const DiagnoseFlags &flags, const CommonOptions &common) {
    if (flags.picture.empty() == flags.own.empty()) {
        throw InputError("diagnose: expected either a PICTURE or --own FILE.glsl, got {}",
                         flags.own.empty() ? "none" : "both");
    }
    if (flags.size && flags.own.empty()) {
        throw InputError("--size: a PICTURE has its own size; this is of --own");
    }
    if (!flags.out.empty()) {
        check_output(flags.out, {".png"});
    }
    const OwnShader own = read_own(flags.own);
    DiagnosisRequest request;
    request.technique = known_technique(flags, own);
    Size size = flags.size.value_or(Size{640, 480});
    if (!own) {
        request.observed = decode_observed(read_file(flags.picture), flags.picture.string());
        size = request.observed.numbers.size;
        with_flag(flags.picture.string(), [&] { check_size(size); });
    }
    request.scene = open_scene(common, flags.scene, flags.view, size);
    const std::string arguments = scene_arguments(common, flags.scene, flags.view);
    if (own) { // it may hold for such a scene alone
        request.trials = {changed_scenes(request.scene, arguments), builtin_trials(scene_assets(common))};
    } else {
        request.trials = {trial_scenes(request.scene, arguments, scene_assets(common))};
    }

    DrawingSession session(common);
    if (own) {
        draw_observed(request, own, size, diagnosis_drawn_by(session.renderer()).picture);
    }
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

void add_diagnose_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<DiagnoseFlags>();
    add_scene(command, flags->scene);
    add_value(command, "PICTURE", "", flags->picture,
              ".png (8 bit, as displayed) or .pfm (linear), of any program, of any size, seen by the scene's camera");
    add_value(command, "--own", "FILE.glsl", flags->own, "Own shading in place of PICTURE (see: own --starter)");
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size at which own shading is drawn [640x480]");
    add_value(command, "--technique", "T", flags->technique,
              "Frequency, model and variants that are known; faults in it are dropped [all are searched; of --own "
              "per-pixel/own]");
    add_view_name(command, flags->view);
    command.add_flag("--json", flags->json, "Print JSON");
    add_value(command, "--out", "FILE.png", flags->out, "Write the picture less what explains it best");
    command.footer(
        "Draws what is known and compares it at every pixel that shows an object: each frequency and model with no\n"
        "fault, with one, then other ways to write numbers (sRGB, gamma 2.2, upside down), other light (a factor, a\n"
        "light or a term missing, ambient light doubled, attenuation or cones left out, other exponents), then two\n"
        "faults, or one under other light. An explanation differs from the picture by at most one level of 8 bits;\n"
        "where none does everywhere, outlines, edges between triangles, jumps of the equation and what rounding\n"
        "decides are left out, as `compare` leaves them out, and a highlight may be off by what pow() loses in "
        "float32\n"
        "(only exponents from some 1000 on). Few faults come first; where none is needed, the picture is right.\n"
        "Own shading is drawn at the frequency of --technique and held against that frequency alone; flat/own,\n"
        "per-vertex/own or per-pixel/own leaves the model open. Verdicts:\n"
        "  right    no fault and no convention is needed (exit code 0; else 1)\n"
        "  named    one explanation\n"
        "  tied     several: `ties` are the others, of as few faults, that differ from `technique` by at most one\n"
        "           level at every compared pixel; a scene is proposed in which they differ, and own shading is\n"
        "           drawn there, too: `after_proposal` holds those that remain\n"
        "  unknown  nothing known explains the picture; the nearest is told\n"
        "JSON: verdict, technique, ties, conventions, residual (levels), residual_rms, residual_pixels,\n"
        "compared_pixels, compared_share, masked, pixel (that shows it best, with its terms), proposal,\n"
        "after_proposal.");
    run_when_chosen(command, common, run, flags, run_diagnose);
}

} // namespace sandbox
