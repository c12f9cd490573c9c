#include "commands/commands.h"

#include "commands/progress_bar.h"
#include "commands/session.h"
#include "measure/metrics/metrics.h"

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace sandbox {
namespace {

constexpr std::string_view reference_word = "reference";

struct CompareFlags {
    std::string scene, left, right, view;
    std::string size{default_size};
    bool json = false;
    std::optional<double> max_abs;
};

bool is_reference(std::string_view text) {
    return text.starts_with(reference_word) &&
           (text.size() == reference_word.size() || text[reference_word.size()] == ':');
}

/// `reference[:key=value,...]`: the left model, per-pixel, every fault off, then what the keys change. Beside the
/// technique's keys: frequency and model.
Technique reference_technique(Technique left, std::string_view text) {
    std::string frequency = "per-pixel";
    std::string model = to_string(Technique{.model = left.model}).substr(frequency.size() + 1);
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
    return parse_technique(frequency + "/" + model + others);
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

/// The contract's keys first.
nlohmann::ordered_json figures(const Comparison &comparison, Size size) {
    const Metrics &m = comparison.metrics;
    const auto width = static_cast<std::size_t>(size.width);
    return {{"rmse", m.norms.rmse},
            {"mean_abs", m.norms.mean_abs},
            {"max_abs", m.norms.max_abs},
            {"p99_abs", m.norms.p99_abs},
            {"psnr", m.psnr ? nlohmann::ordered_json(*m.psnr) : nlohmann::ordered_json()},
            {"flip", m.flip},
            {"max_levels", m.max_levels},
            {"differing_share", m.differing_share},
            {"compared_pixels", m.compared_pixels},
            {"silhouette_pixels", m.silhouette_pixels},
            {"edge_pixels", m.edge_pixels},
            {"jump_pixels", m.jump_pixels},
            {"nonfinite_pixels", m.nonfinite_pixels},
            {"worst_pixel", {m.worst_pixel % width, m.worst_pixel / width}},
            {"worst_pixel_rounding", comparison.worst_pixel_rounding}};
}

std::string short_number(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string human_table(const nlohmann::ordered_json &figures) {
    std::string table;
    for (const auto &[key, value] : figures.items()) {
        const std::string text = value.is_number_float() ? short_number(value.get<double>())
                                 : value.is_null()       ? "infinite"
                                 : value.is_string()     ? value.get<std::string>()
                                                         : value.dump();
        table.append(key).append(22 - key.size(), ' ').append(text).append("\n");
    }
    return table;
}

/// --max-abs: a comparison of nothing proves nothing.
bool within(const Metrics &metrics, double bound) {
    if (metrics.compared_pixels == 0) {
        note("--max-abs: no pixel could be compared");
        return false;
    }
    if (!(metrics.norms.max_abs <= bound)) {
        note("max_abs " + short_number(metrics.norms.max_abs) + " is above " + short_number(bound));
        return false;
    }
    return true;
}

int run_compare(const CompareFlags &flags, const CommonOptions &common) {
    const Technique left = with_flag("--left", [&] { return parse_technique(flags.left); });
    const bool to_reference = is_reference(flags.right);
    const Technique right = with_flag("--right", [&] {
        return to_reference ? reference_technique(left, flags.right) : parse_technique(flags.right);
    });
    if (flags.max_abs && !(std::isfinite(*flags.max_abs) && *flags.max_abs >= 0)) {
        throw InputError("--max-abs: expected a number >= 0");
    }
    const Size size = parse_size(flags.size);
    const Scene scene = open_scene(common, flags.scene, flags.view);

    DrawingSession session(common);
    const Frame drawn = session.renderer().render(scene, left, size, true);
    const Comparison comparison = to_reference
                                      ? compare_to_reference(drawn, scene, right, size, session.renderer().resources())
                                      : Comparison{compare(drawn, session.renderer().render(scene, right, size, true))};
    nlohmann::ordered_json all = figures(comparison, size);
    all["scene"] = flags.scene;
    all["left"] = to_string(left);
    all["right"] = (to_reference ? "reference of " : "") + to_string(right);
    all["size"] = flags.size;
    all["renderer"] = session.context().renderer();
    print(flags.json ? all.dump(2) + "\n" : human_table(all));
    return flags.max_abs && !within(comparison.metrics, *flags.max_abs) ? 1 : 0;
}

} // namespace

void add_compare(CLI::App &app, CommonOptions &common, Run &run) {
    CLI::App *command = app.add_subcommand("compare", "How far one picture of a scene is from another, in numbers");
    auto flags = std::make_shared<CompareFlags>();
    command->add_option("SCENE", flags->scene, "Built-in name, .json or .obj")->type_name("")->required();
    command->add_option("--left", flags->left, "The technique that is judged")->type_name("T")->required();
    command->add_option("--right", flags->right, "What it is judged against")
        ->type_name("T|reference[:key=value,...]")
        ->required();
    command->add_option("--size", flags->size, "Of both pictures")->type_name("WxH")->capture_default_str();
    command->add_option("--view", flags->view, "One of the scene's named views")->type_name("NAME");
    command->add_flag("--json", flags->json, "As JSON; infinite figures are null");
    command->add_option("--max-abs", flags->max_abs, "Exit 1 if max_abs is above this")->type_name("X");
    command->footer(
        "reference: the left model, per-pixel, every fault off, in double; keys change that (frequency and\n"
        "model too). Compared are the pixels where both show the same object, but for those at an edge between\n"
        "triangles or a jump of the equation in the reference (counted apart), in linear RGB. psnr has peak 1,\n"
        "null where nothing differs; flip is of the whole picture in 8 bits. A picture with a pixel that is not\n"
        "finite has infinite errors. worst_pixel is where max_abs is, or the first pixel that is not finite;\n"
        "worst_pixel_rounding, how far the reference's colour moves there when float32 rounds the triangle's\n"
        "place in the window, which no float32 renderer can promise to beat.");
    add_common_options(*command, common);
    command->callback([flags, &common, &run] { run = [flags, &common] { return run_compare(*flags, common); }; });
}

} // namespace sandbox
