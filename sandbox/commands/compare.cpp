#include "commands/commands.h"

#include "commands/own_flags.h"
#include "commands/progress_bar.h"
#include "commands/session.h"
#include "measure/metrics/certificate_figures.h"
#include "measure/metrics/metrics.h"
#include "shading/prepared_object.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace sandbox {
namespace {

constexpr std::string_view reference_word = "reference";

struct CompareFlags {
    std::string scene, left, right, view;
    OwnFlags own;
    Size size = default_picture_size;
    bool json = false;
    std::optional<double> max_abs;
};

bool is_reference(std::string_view text) {
    return text.starts_with(reference_word) &&
           (text.size() == reference_word.size() || text[reference_word.size()] == ':');
}

/// `reference[:key=value,...]`: the model and normalisation of the left technique, per-pixel, every fault off, then
/// what the keys change. frequency and model count as keys, too.
Technique reference_technique(const Technique &left, std::string_view text) {
    std::string frequency = "per-pixel";
    std::string model(model_values[static_cast<std::size_t>(left.model)].name);
    std::string others;
    text.remove_prefix(std::min(text.size(), reference_word.size() + 1));
    std::istringstream settings{std::string(text)};
    for (std::string setting; std::getline(settings, setting, ',');) {
        if (setting.starts_with("frequency=")) {
            frequency = setting.substr(10);
        } else if (setting.starts_with("model=")) {
            model = setting.substr(6);
        } else {
            others += (others.empty() ? ":" : ",") + setting;
        }
    }
    if (left.model == Model::own && model == model_key.value(left).name) {
        throw InputError("own shading has no reference: name the model that it is held against, as in "
                         "reference:model=phong");
    }
    Technique reference = parse_technique(fmt::format("{}/{}{}", frequency, model, others));
    if (others.find("normalisation=") == std::string::npos && reference.model == left.model) {
        reference.normalisation = left.normalisation;
    }
    return reference;
}

struct Comparison {
    Metrics metrics;
    double worst_pixel_rounding = 0; ///< PixelProbe::window_rounding there; 0 between two drawn pictures

    [[nodiscard]] bool nothing_compared() const { return metrics.compared_pixels == 0; }
};

Comparison compare_to_reference(const Frame &left, const Scene &scene, const Technique &technique, Size size,
                                Resources &resources) {
    ProgressBar bar("reference");
    const std::vector<ObjectResources> loaded = resources.load(scene);
    Comparison comparison{
        compare(left, render_reference(scene, loaded, technique, size, Surface::mesh, [&](double share) {
                    bar.report(share);
                    return true;
                }))};
    const int worst = static_cast<int>(comparison.metrics.worst_pixel);
    const auto probe = probe_pixel(scene, loaded, technique, size, worst % size.width, worst / size.width);
    comparison.worst_pixel_rounding = probe ? probe->window_rounding : 0;
    return comparison;
}

/// Every metric, then the worst pixel: what the table and the JSON show, in their order.
nlohmann::ordered_json figures(const Comparison &comparison, Size size) {
    const auto width = static_cast<std::size_t>(size.width);
    const std::size_t worst = comparison.metrics.worst_pixel;
    nlohmann::ordered_json json;
    for_each_metric(comparison.metrics, [&](const auto &metric, const auto &measured) {
        json[metric.name] = quantity_json<nlohmann::ordered_json>(metric, measured);
    });
    const bool somewhere = !comparison.nothing_compared() || comparison.metrics.nonfinite_pixels > 0;
    json["worst_pixel"] = somewhere ? nlohmann::ordered_json{worst % width, worst / width} : nlohmann::ordered_json();
    json["worst_pixel_rounding"] = somewhere ? comparison.worst_pixel_rounding : unmeasured;
    const std::string why = why_untrusted(comparison.metrics);
    json["reason"] = why.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(why);
    return json;
}

/// Of the left technique, where its frequency is auto: `auto_bound` and the like.
void add_certificate(nlohmann::ordered_json &json, const Scene &scene, const Technique &technique, Size size,
                     Resources &resources) {
    if (technique.frequency != Frequency::automatic) {
        return;
    }
    const std::vector<ObjectResources> loaded = resources.load(scene);
    const auto picture = [&](const Technique &drawn) { return render_reference(scene, loaded, drawn, size); };
    const CertificateFigures figures = certificate_figures(scene, loaded, technique, picture(technique),
                                                           picture(part_of_auto(technique, Frequency::per_pixel)));
    for (const Quantity<CertificateFigures> &quantity : certificate_quantities) {
        json[fmt::format("auto_{}", quantity.name)] = quantity_json<nlohmann::ordered_json>(quantity, figures);
    }
    json["auto_reason"] =
        figures.nothing_proved.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(figures.nothing_proved);
}

/// The settings that are on, at the left or the right, and change no pixel of the scene on any side where they are.
nlohmann::ordered_json no_effect(const Scene &scene, const Technique &left, const Technique &right) {
    nlohmann::ordered_json keys = nlohmann::ordered_json::array();
    for (const TechniqueKey &key : technique_settings) {
        bool on = false;
        bool matters = false;
        for (const Technique &side : {left, right}) {
            const int value = key.get(side);
            on = on || value != 0;
            matters = matters || (value != 0 && can_matter(key, value, scene, side));
        }
        if (on && !matters) {
            keys.push_back(key.name);
        }
    }
    return keys;
}

std::string human_table(const nlohmann::ordered_json &figures) {
    const auto number = [](double value) {
        return std::isnan(value) ? "none" : std::isinf(value) ? "infinite" : fmt::format("{:g}", value);
    };
    std::string table;
    for (const auto &[key, value] : figures.items()) {
        const std::string text = value.is_number_float() ? number(value.get<double>())
                                 : value.is_null()       ? (key == "psnr" ? "infinite" : "none")
                                 : value.is_string()     ? value.get<std::string>()
                                                         : value.dump();
        table += fmt::format("{:<26}{}\n", key, text);
    }
    return table;
}

/// One line a metric, for the help.
std::string metric_lines() {
    std::string lines;
    for_each_metric(Metrics{}, [&](const auto &metric, const auto &) {
        lines += fmt::format("  {:<22}{} ({})\n", metric.name, metric.meaning, metric.unit);
    });
    return lines;
}

/// Checks --max-abs.
bool within(const Metrics &metrics, double bound) {
    if (!(metrics.norms.max_abs <= bound)) {
        note(fmt::format("max_abs {:g} is above {:g}", metrics.norms.max_abs, bound));
        return false;
    }
    return true;
}

int run_compare(const CompareFlags &flags, const CommonOptions &common) {
    const bool to_reference = is_reference(flags.right);
    OwnTechniques techniques(flags.own);
    const Technique left = techniques.left(flags.left);
    const Technique right = to_reference ? with_flag("--right", [&] { return reference_technique(left, flags.right); })
                                         : techniques.right(flags.right);
    techniques.require_all_used();
    if (flags.max_abs && !(std::isfinite(*flags.max_abs) && *flags.max_abs >= 0)) {
        throw InputError("--max-abs: expected a number >= 0");
    }
    const Scene scene = open_scene(common, flags.scene, flags.view, flags.size);

    DrawingSession session(common);
    const Frame drawn = session.renderer().render(scene, left, flags.size, true);
    const Comparison comparison =
        to_reference ? compare_to_reference(drawn, scene, right, flags.size, session.renderer().resources())
                     : Comparison{compare(drawn, session.renderer().render(scene, right, flags.size, true))};
    nlohmann::ordered_json all = figures(comparison, flags.size);
    add_certificate(all, scene, left, flags.size, session.renderer().resources());
    all["no_effect"] = no_effect(scene, left, right);
    const auto resources = session.renderer().resources().load(scene);
    all["same_picture"] = !to_reference && same_picture(scene, left, right, resources);
    if (to_reference) {
        note_no_effect(scene, left);
    } else {
        note_no_effect(scene, left, right, resources);
    }
    all["scene"] = flags.scene;
    all["left"] = to_string(left);
    all["right"] = (to_reference ? "reference of " : "") + to_string(right);
    all["size"] = fmt::format("{}x{}", flags.size.width, flags.size.height);
    all["renderer"] = session.context().renderer();
    print(flags.json ? all.dump(2) + "\n" : human_table(all));
    if (const std::string why = why_untrusted(comparison.metrics); !why.empty()) {
        note((comparison.nothing_compared() ? "nothing is compared: " : "the figures say little: ") + why);
    }
    const bool proves = !comparison.nothing_compared(); // a comparison of no pixels proves nothing
    return proves && (!flags.max_abs || within(comparison.metrics, *flags.max_abs)) ? 0 : 1;
}

} // namespace

void add_compare_options(CLI::App &command, CommonOptions &common, Run &run) {
    const auto flags = std::make_shared<CompareFlags>();
    add_scene(command, flags->scene);
    add_value(command, "--left", "T", flags->left, "Technique to judge")->required();
    add_value(command, "--right", "T|reference[:key=value,...]", flags->right,
              "Technique, or reference, to judge it against")
        ->required();
    add_own_files(command, flags->own, true);
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size of both pictures [1280x720]");
    add_view_name(command, flags->view);
    command.add_flag("--json", flags->json, "Print JSON; infinite figures and those over no pixels are null");
    add_value(command, "--max-abs", "X", flags->max_abs, "Exit 1 if max_abs is above this");
    command.footer(
        "reference: the model of the left technique, per-pixel, every fault off, in double precision; keys of a\n"
        "technique, frequency and model change that; of own shading, the model must be named.\n"
        "Errors use the pixels where both pictures show the same object, except those at an edge between\n"
        "triangles, at a jump of the equation in the reference, or where float32 rounding alone decides;\n"
        "each of those counts under the first of these causes. If a pixel is not finite, all errors are\n"
        "infinite. If no pixel is compared, there are no errors, and the exit code is 1. Figures, with their\n"
        "units:\n" +
        metric_lines() +
        "  worst_pixel           where max_abs is, or the first pixel that is not finite (x, y)\n"
        "  worst_pixel_rounding  how far the reference's colour moves there when float32 rounds the\n"
        "                        corners of the triangle: no float32 renderer can promise less\n"
        "  reason                why the errors say little, or are none: less than half is compared\n"
        "  auto_...              of a left technique with the frequency auto: its promise (tolerance), what is\n"
        "                        proved (bound), the true error beside per-pixel on the same mesh, the share\n"
        "                        of the area seen that is lit per vertex, its triangles, the time to choose;\n"
        "                        reason: why no triangle is, where a key of the technique decides that\n"
        "  no_effect             keys that are on and cannot change a pixel of this scene\n"
        "  same_picture          both techniques draw the scene with the same programs and numbers");
    run_when_chosen(command, common, run, flags, run_compare);
}

} // namespace sandbox
