#include "commands/commands.h"

#include "commands/progress_bar.h"
#include "commands/session.h"
#include "measure/metrics/metrics.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace sandbox {
namespace {

constexpr std::string_view reference_word = "reference";

struct CompareFlags {
    std::string scene, right, view;
    Technique left;
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
Technique reference_technique(Technique left, std::string_view text) {
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
    Technique reference = parse_technique(fmt::format("{}/{}{}", frequency, model, others));
    if (others.find("normalisation=") == std::string::npos && reference.model == left.model) {
        reference.normalisation = left.normalisation;
    }
    return reference;
}

struct Comparison {
    Metrics metrics;
    double worst_pixel_rounding = 0; ///< PixelProbe::window_rounding there; 0 between two drawn pictures
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
    json["worst_pixel"] = {worst % width, worst / width};
    json["worst_pixel_rounding"] = comparison.worst_pixel_rounding;
    return json;
}

std::string human_table(const nlohmann::ordered_json &figures) {
    std::string table;
    for (const auto &[key, value] : figures.items()) {
        const std::string text = value.is_number_float() ? fmt::format("{:g}", value.get<double>())
                                 : value.is_null()       ? "infinite"
                                 : value.is_string()     ? value.get<std::string>()
                                                         : value.dump();
        table += fmt::format("{:<22}{}\n", key, text);
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

/// Checks --max-abs. A comparison of no pixels fails: it proves nothing.
bool within(const Metrics &metrics, double bound) {
    if (metrics.compared_pixels == 0) {
        note("--max-abs: no pixel could be compared");
        return false;
    }
    if (!(metrics.norms.max_abs <= bound)) {
        note(fmt::format("max_abs {:g} is above {:g}", metrics.norms.max_abs, bound));
        return false;
    }
    return true;
}

int run_compare(const CompareFlags &flags, const CommonOptions &common) {
    const bool to_reference = is_reference(flags.right);
    const Technique right = with_flag("--right", [&] {
        return to_reference ? reference_technique(flags.left, flags.right) : parse_technique(flags.right);
    });
    if (flags.max_abs && !(std::isfinite(*flags.max_abs) && *flags.max_abs >= 0)) {
        throw InputError("--max-abs: expected a number >= 0");
    }
    const Scene scene = open_scene(common, flags.scene, flags.view);

    DrawingSession session(common);
    const Frame drawn = session.renderer().render(scene, flags.left, flags.size, true);
    const Comparison comparison =
        to_reference ? compare_to_reference(drawn, scene, right, flags.size, session.renderer().resources())
                     : Comparison{compare(drawn, session.renderer().render(scene, right, flags.size, true))};
    nlohmann::ordered_json all = figures(comparison, flags.size);
    all["scene"] = flags.scene;
    all["left"] = to_string(flags.left);
    all["right"] = (to_reference ? "reference of " : "") + to_string(right);
    all["size"] = fmt::format("{}x{}", flags.size.width, flags.size.height);
    all["renderer"] = session.context().renderer();
    print(flags.json ? all.dump(2) + "\n" : human_table(all));
    return flags.max_abs && !within(comparison.metrics, *flags.max_abs) ? 1 : 0;
}

} // namespace

void add_compare(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App &command = *app.add_subcommand("compare", "Measure how far one picture of a scene is from another");
    const auto flags = std::make_shared<CompareFlags>();
    add_scene(command, flags->scene);
    add_parsed(command, "--left", "T", flags->left, parse_technique, "Technique to judge")->required();
    add_value(command, "--right", "T|reference[:key=value,...]", flags->right,
              "Technique, or reference, to judge it against")
        ->required();
    add_parsed(command, "--size", "WxH", flags->size, parse_size, "Size of both pictures [1280x720]");
    add_view_name(command, flags->view);
    command.add_flag("--json", flags->json, "Print JSON; infinite figures are null");
    add_value(command, "--max-abs", "X", flags->max_abs, "Exit 1 if max_abs is above this");
    command.footer(
        "reference: the model of the left technique, per-pixel, every fault off, in double precision; keys of a\n"
        "technique, frequency and model change that. Errors use the pixels where both pictures show the\n"
        "same object, except those at an edge between triangles or at a jump of the equation in the\n"
        "reference. If a pixel is not finite, all errors are infinite. Figures, with their units:\n" +
        metric_lines() +
        "  worst_pixel           where max_abs is, or the first pixel that is not finite (x, y)\n"
        "  worst_pixel_rounding  how far the reference's colour moves there when float32 rounds the\n"
        "                        corners of the triangle: no float32 renderer can promise less");
    run_when_chosen(command, common, run, flags, run_compare);
}

} // namespace sandbox
