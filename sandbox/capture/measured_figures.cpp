#include "capture/measured_figures.h"

#include "capture/grid.h"
#include "capture/labels.h"
#include "image/cut_paste.h"
#include "image/difference.h"
#include "image/error.h"
#include "image/png.h"
#include "measure/report/figure_plots.h"
#include "measure/report/paper.h"
#include "measure/report/text.h"
#include "measure/report/work_precision_plot.h"
#include "measure/work_precision/findings.h"
#include "words/row_words.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace sandbox {
namespace {

constexpr double thick = 6; ///< of the truth's curve, which lies behind the others

/// Rungs of the ladder alone: the scene's own meshes may lie between them.
std::vector<const MeasuredRow *> rungs_of(const WorkPrecision &measured) {
    std::vector<const MeasuredRow *> rungs;
    for (const MeasuredRow &row : measured.rows) {
        if (row.plan.group == RowGroup::ladder && row.refused.empty() && row.errors) {
            rungs.push_back(&row);
        }
    }
    return rungs;
}

/// A scene whose meshes can be made finer: the whole one, or its lone sphere.
bool has_ladder(const Scene &scene) {
    return std::ranges::none_of(scene.objects,
                                [](const Object &object) { return std::holds_alternative<ObjShape>(object.mesh); });
}

/// The picture over a strip with the scale of its differences.
ByteImage over_scale(const ByteImage &picture, const Words &words, double largest, double gain) {
    const Strips strips = strips_for(picture.size.width, {.labels = {}, .splits = {}, .scale = true}, 24);
    ByteImage whole = black_picture({picture.size.width, picture.size.height + strips.below});
    paste(whole, picture, 0, 0);
    if (strips.below > 0) {
        const std::string &truth = words.text("truth"), &own = words.text("figures.per_vertex");
        draw_scale(whole, strips,
                   {.what = fmt::format("{} - {}", own, truth),
                    .result = difference_text(words, largest) + words.text("difference.edges"),
                    .low = words.format("difference.brighter", truth),
                    .high = words.format("difference.brighter", own),
                    .gain = gain});
    }
    return whole;
}

/// Rung by rung and, last, the truth; below each what it differs by from the truth.
ByteImage rungs_picture(const FigureWork &work, const WorkPrecision &measured, const DrawRows &draw) {
    const Words words = words_of_labels(work.request.pair.language);
    const PictureOptions &shown = work.request.pair;
    const Technique technique = measured.options.only.front();
    std::vector<std::string> columns;
    std::vector<Image> views;
    for (const MeasuredRow *row : rungs_of(measured)) {
        const PlannedMesh &mesh = measured.meshes[row->plan.mesh];
        columns.push_back(words.format("mesh.triangles", mesh.triangles));
        views.push_back(draw.picture(mesh.scene, technique).color);
    }
    columns.push_back(words.text("truth"));
    views.push_back(to_frame(report_truth(technique.model, measured.no_analytic_surface.empty(), measured.meshes,
                                          measured.options.size, draw.load))
                        .color);
    double largest = 0, largest_error = 0; // edges, where one shows the background, are no errors
    for (const Image &view : views) {
        largest = std::max(largest, largest_difference(view, views.back()));
    }
    for (const MeasuredRow *row : rungs_of(measured)) {
        largest_error = std::max(largest_error, row->errors->total.norms.max_abs);
    }
    const double gain = fitting_gain(largest_error);
    const std::vector<std::string> rows{title_of(words, technique),
                                        words.format("figures.difference_row", fmt::format("{:g}", gain))};
    const ByteImage grid = grid_picture(rows, columns, measured.options.size, [&](std::size_t row, std::size_t column) {
        return row == 0 ? to_display(views[column], shown.display, shown.exposure)
                        : difference_picture(views[column], views.back(), gain);
    });
    return over_scale(grid, words, largest, gain);
}

std::string rungs_table(const Words &words, const WorkPrecision &measured) {
    std::string table = table_head([&] {
        auto heads =
            with_error_heads(words, {words.text("report.column.rings"), words.text("report.column.triangles")});
        heads.push_back(words.text("figures.order"));
        return heads;
    }());
    const std::vector<OrderStep> steps = convergence_orders(measured);
    for (const MeasuredRow *row : rungs_of(measured)) {
        const PlannedMesh &mesh = measured.meshes[row->plan.mesh];
        auto cells =
            with_error_cells({fmt::format("{}", mesh.rings), fmt::format("{}", mesh.triangles)}, row->errors->total);
        const auto step =
            std::ranges::find_if(steps, [&](const OrderStep &s) { return &measured.rows[s.fine] == row; });
        cells.push_back(step != steps.end() && step->total.l2 ? fmt::format("{:.2f}", *step->total.l2) : "");
        table += table_row(cells);
    }
    return table;
}

std::string own_mesh_table(const Words &words, const WorkPrecision &measured, Model model) {
    std::string table =
        table_head(with_error_heads(words, {words.text("figures.on_own_mesh"), words.text("figures.milliseconds")}));
    for (const MeasuredRow &row : measured.rows) {
        if (row.plan.mesh == own_mesh(measured) && is_base(row) && row.complete() &&
            row.plan.technique.model == model) {
            table += table_row(with_error_cells({to_string(row.plan.technique), milliseconds_text(row.time->median)},
                                                row.errors->total));
        }
    }
    return table;
}

/// The cheapest within one level, and those that noise alone may put behind it.
std::string cheapest_words(const Words &words, const WorkPrecision &measured, Model model) {
    const auto best = cheapest(measured, model, ErrorNorm::rmse, error_bounds[0]);
    if (!best) {
        return {};
    }
    const auto name = [&](std::size_t i) {
        const PlannedRow &row = measured.rows[i].plan;
        return fmt::format("`{}` ({})", to_string(row.technique), mesh_words(words, measured.meshes[row.mesh]));
    };
    std::vector<std::string> ties;
    for (const std::size_t tie : ties_of(measured, *best, ErrorNorm::rmse, error_bounds[0])) {
        ties.push_back(name(tie));
    }
    return words.format("figures.cheapest", name(*best), milliseconds_text(measured.rows[*best].time->median)) +
           (ties.empty() ? "" : words.format("figures.ties", fmt::join(ties, words.text("list.comma"))));
}

std::string machine_words(const Words &words, const Machine &machine) {
    return words.format("figures.machine", machine.renderer, machine.processor, machine.threads, machine.clock);
}

} // namespace

Figure subdivision_figure(const FigureWork &work, const Progress &progress) {
    const Words &words = work.request.words;
    const Technique technique{.frequency = Frequency::per_vertex, .model = work.request.pair.left.model};
    const bool whole = has_ladder(work.request.scene);
    const Scene &scene = whole ? work.request.scene : work.sphere.scene;
    PlanOptions options = quick_plan();
    options.only = {technique};
    options.size = whole ? Size{work.request.view.width / 2, work.request.view.height / 2}
                         : Size{work.request.view.width / 2, work.request.view.width / 2};
    options.warm_ups = options.repeats = 0;
    const DrawRows draw{
        work.draw.load, [&](const Scene &s, const Technique &t) { return work.draw.picture(s, t, options.size); }, {}};
    const WorkPrecision measured = measure_work_precision(scene, options, draw, progress);
    if (!measured.finished) {
        throw Cancelled();
    }
    std::vector<std::string> rings;
    std::string warnings;
    for (const MeasuredRow *row : rungs_of(measured)) {
        rings.push_back(fmt::format("{}", measured.meshes[row->plan.mesh].rings));
        warnings = warnings.empty() ? warning(words, row->errors->total) : warnings;
    }
    const bool analytic = measured.no_analytic_surface.empty();
    Figure figure{words.text("figures.subdivision"),
                  words.format("figures.subdivision.caption", title_of(words, technique),
                               fmt::join(rings, words.text("list.comma")), options.size.width, options.size.height,
                               words.format(analytic ? "report.truth_surface" : "report.truth_mesh",
                                            title_of(words, model_key, static_cast<int>(technique.model)))) +
                      (whole ? "" : words.text("figures.no_ladder") + sphere_words(words, work.sphere)) + warnings,
                  rungs_table(words, measured),
                  {},
                  {}};
    figure.files.push_back({"subdivision.png", encode_png(rungs_picture(work, measured, draw))});
    add_plot(figure, work, "subdivision-error", [&](const Words &w) { return subdivision_plot(w, measured); });
    return figure;
}

Figure profile_figure(const FigureWork &work, const Progress &) {
    const Words &words = work.request.words;
    const FigureSide &left = work.sides[0], &right = work.sides[1]; // a lambda cannot capture bindings (Clang 14)
    const Size view = work.request.view;
    const bool differ = work.between.norms.max_abs > 0;
    const int x = differ ? static_cast<int>(work.between.worst_pixel) % view.width : view.width / 2;
    const int y = differ ? static_cast<int>(work.between.worst_pixel) / view.width : view.height / 2;
    const Image truth = to_frame(left.truth).color, other_truth = to_frame(right.truth).color;
    const MeshFactors &factors = work.request.pair.mesh_factors;
    const bool two_truths = left.technique.model != right.technique.model || factors[0] != factors[1];
    const auto curves = [&](const Words &w) {
        std::vector<NamedCurve> all{
            {truth_label(w, left.technique, factors[0]), style_truth, luminance_row(truth, y), thick}};
        if (two_truths) {
            all.push_back({truth_label(w, right.technique, factors[1]), 0, luminance_row(other_truth, y), thick});
        }
        all.push_back({"A  " + side_title(work, w, false), style_a, luminance_row(left.drawn.color, y)});
        all.push_back({"B  " + side_title(work, w, true), style_b, luminance_row(right.drawn.color, y)});
        return all;
    };
    const auto value = [&](const Image &image) { return short_number(luminance(image.at(x, y))); };
    PictureOptions options = pair_options(work, Layout::side_by_side, {2 * view.width, view.height});
    options.samples = 1;
    options.marks.profile = (y + 0.5) / view.height;
    Figure figure{words.text("figures.profile"),
                  words.format("figures.profile.caption", y, view.height) +
                      (differ ? words.format("figures.profile.worst", x, value(left.drawn.color),
                                             value(right.drawn.color), value(truth))
                              : words.text("figures.profile.equal")),
                  {},
                  {},
                  {}};
    add_capture(figure, work, "profile-line", show_picture(work.request.scene, options, work.draw.painters),
                sidecar_text(work.request.scene, options, work.draw.by, work.request.out));
    add_plot(figure, work, "profile", [&](const Words &w) { return profile_plot(w, y, curves(w)); });
    return figure;
}

Figure error_time_figure(const FigureWork &work, const Progress &progress) {
    const Words &words = work.request.words;
    const Model model = work.request.pair.left.model;
    PlanOptions options = quick_plan();
    options.repeats = PlanOptions{}.repeats; // few rows: as many as a full report has cost little
    for (const Frequency frequency : all_frequencies) {
        options.only.push_back({.frequency = frequency, .model = model});
    }
    const WorkPrecision measured = measure_work_precision(work.request.scene, options, work.draw.timed, progress);
    if (!measured.finished) {
        throw Cancelled();
    }
    const std::string model_words = title_of(words, model_key, static_cast<int>(model));
    std::string caption = words.format(
        "figures.error_time.caption", model_words, measured.options.size.width, measured.options.size.height,
        measured.options.repeats,
        words.format(measured.no_analytic_surface.empty() ? "report.truth_surface" : "report.truth_mesh", model_words));
    for (const MeasuredRow &row : measured.rows) {
        if (!row.refused.empty() && row.plan.mesh == own_mesh(measured)) {
            caption += words.format("figures.refused", to_string(row.plan.technique), row.refused);
        }
    }
    caption += cheapest_words(words, measured, model);
    caption += has_ladder(work.request.scene) ? "" : words.text("figures.single_points");
    Figure figure{words.text("figures.error_time"),
                  caption + machine_words(words, work.draw.machine),
                  own_mesh_table(words, measured, model),
                  {fmt::format("shading-sandbox report {}{} --quick --repeats {} --out report",
                               work.request.scene_arguments, work.request.common_arguments, options.repeats)},
                  {}};
    add_plot(figure, work, "error-time", [&](const Words &w) {
        PlotRequest plot = error_time_plot(w, measured, model, ErrorNorm::rmse);
        plot.title = w.format("figures.error_time.title", title_of(w, model_key, static_cast<int>(model)));
        return plot;
    });
    return figure;
}

} // namespace sandbox
