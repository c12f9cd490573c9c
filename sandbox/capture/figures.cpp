#include "capture/figures.h"

#include "capture/figure_work.h"
#include "capture/grid.h"
#include "capture/plot_picture.h"
#include "image/error.h"
#include "image/picture_size.h"
#include "image/png.h"
#include "measure/report/svg.h"
#include "measure/report/text.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace sandbox {
namespace {

constexpr int least_side = 32;
constexpr int samples = 4; ///< a pixel of pictures that nothing is measured in
constexpr std::array<std::string_view, 4> exponents{"2", "8", "32", "128"};

/// How a figure is made, and its share of the time, roughly.
struct FigureKind {
    Figure (*make)(const FigureWork &, const Progress &);
    double share;
};
constexpr FigureKind kinds[]{{pair_figure, 0.04},       {exponents_figure, 0.06}, {subdivision_figure, 0.2},
                             {difference_figure, 0.03}, {profile_figure, 0.07},   {error_time_figure, 0.6}};

FigureSide side_of(const FigureRequest &request, const FigureDraw &draw, bool right) {
    FigureSide side;
    side.scene = with_mesh_factor(request.scene, request.pair.mesh_factors[right ? 1 : 0]);
    side.technique = right ? request.pair.right : request.pair.left;
    side.drawn = draw.picture(side.scene, side.technique, request.view);
    Technique truth = truth_of(side.technique);
    truth.normalisation = side.technique.normalisation; // a factor of the model, no fault
    side.truth = render_reference(side.scene, draw.load(side.scene), truth, request.view);
    side.errors = compare(side.drawn, side.truth, Flip::without);
    return side;
}

std::string compare_command(const FigureWork &work, const std::string &left, const std::string &right) {
    const FigureRequest &request = work.request;
    return fmt::format("shading-sandbox compare {}{} --left {} --right {} --size {}x{}", request.scene_arguments,
                       request.common_arguments, left, right, request.view.width, request.view.height);
}

/// `compare` knows no mesh factors.
bool can_be_compared(const FigureWork &work) { return work.request.pair.mesh_factors == MeshFactors{1, 1}; }

} // namespace

PictureOptions pair_options(const FigureWork &work, Layout layout, Size room) {
    PictureOptions options = work.request.pair;
    options.layout = layout;
    options.labels = true;
    options.size = size_around(options, room);
    return options;
}

double fitting_gain(double largest) {
    if (!std::isfinite(largest) || largest <= 0) {
        return 1;
    }
    const double power = std::pow(10.0, std::floor(std::log10(1 / largest)));
    const double digit = 1 / largest / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

std::string table_row(const std::vector<std::string> &cells) {
    return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string table_head(const std::vector<std::string> &heads) {
    std::string rule = "|---|";
    for (std::size_t i = 1; i < heads.size(); ++i) {
        rule += "---:|";
    }
    return table_row(heads) + rule + "\n";
}

std::vector<std::string> with_error_heads(const Words &words, std::vector<std::string> heads, bool differences) {
    heads.push_back(differences ? words.text("figures.largest_difference") : long_title_of(words, ErrorNorm::max));
    heads.push_back(words.text("figures.levels"));
    heads.push_back(title_of(words, ErrorNorm::rmse));
    heads.push_back(words.text("figures.levels"));
    return heads;
}

std::vector<std::string> with_error_cells(std::vector<std::string> cells, const Metrics &metrics) {
    cells.push_back(short_number(metrics.norms.max_abs));
    cells.push_back(metrics.max_levels ? fmt::format("{}", *metrics.max_levels) : "none");
    cells.push_back(short_number(metrics.norms.rmse));
    cells.push_back(short_number(255 * metrics.norms.rmse));
    return cells;
}

std::string warning(const Words &words, const Metrics &metrics) {
    const std::string why = why_untrusted(words, metrics);
    return why.empty() ? "" : " " + words.format("figures.untrusted", why);
}

std::string sphere_words(const Words &words, const LoneSphere &sphere) {
    const std::string name = sphere.of.empty() ? words.text("figures.unnamed") : sphere.of;
    return words.format(sphere.own ? "figures.own_sphere" : "figures.other_sphere", name) +
           (sphere.made_shiny ? words.text("figures.made_shiny") : "");
}

void add_capture(Figure &figure, const FigureWork &work, const std::string &name, const ByteImage &picture,
                 const std::string &sidecar) {
    figure.files.push_back({name + ".png", encode_png(picture)});
    figure.files.push_back({name + ".png.json", sidecar});
    figure.commands.push_back(fmt::format("shading-sandbox capture {0}/{1}.png.json --out {0}/{1}.png{2}",
                                          work.request.folder, name, work.request.common_arguments));
}

void add_plot(Figure &figure, const FigureWork &work, const std::string &name,
              const std::function<PlotRequest(const Words &)> &plot) {
    const PlotLayout layout = lay_out(plot(work.request.words));
    if (std::ranges::all_of(layout.series, [](const PlotSeries &series) { return series.points.empty(); })) {
        figure.caption += work.request.words.text("figures.no_plot");
        return;
    }
    figure.files.push_back({name + ".svg", plot_file(plot(work.request.words))});
    const Words words = words_of_labels(work.request.pair.language);
    figure.files.push_back({name + ".png", encode_png(plot_picture(plot(words)))});
}

Figure pair_figure(const FigureWork &work, const Progress &) {
    const Words &words = work.request.words;
    const auto &[left, right] = work.sides;
    const Size view = work.request.view;
    PictureOptions options = pair_options(work, Layout::side_by_side, {2 * view.width, view.height});
    options.samples = samples;
    Figure figure{words.text("figures.pair"),
                  words.format("figures.pair.caption", title_of(words, left.technique),
                               title_of(words, right.technique), view.width, view.height, samples) +
                      warning(words, left.errors) + warning(words, right.errors),
                  table_head(with_error_heads(words, {words.text("figures.compared")})),
                  {},
                  {}};
    add_capture(figure, work, "pair", show_picture(work.request.scene, options, work.draw.painters),
                sidecar_text(work.request.scene, options, work.draw.by));
    for (const FigureSide &side : work.sides) {
        const std::string name = &side == &left ? "A" : "B";
        figure.table += table_row(with_error_cells(
            {words.format("figures.against_reference", name, to_string(side.technique))}, side.errors));
        if (can_be_compared(work)) {
            figure.commands.push_back(compare_command(work, to_string(side.technique), "reference"));
        }
    }
    return figure;
}

Figure exponents_figure(const FigureWork &work, const Progress &progress) {
    const Words &words = work.request.words;
    const Scene &scene = work.sphere.scene;
    Grid grid{{{.model = Model::phong}, {.model = Model::blinn_phong}},
              {"objects[0].material.shininess", {exponents.begin(), exponents.end()}}};
    const int side = work.request.view.width / 2;
    PictureOptions options = cell_options(work.request.pair, grid.techniques.front());
    options.size = {side, side};
    options.samples = samples;
    options.mesh_factors = {1, 1};
    Figure figure{words.text("figures.exponents"),
                  words.format("figures.exponents.caption", fmt::join(exponents, words.text("list.comma")), samples) +
                      (scene.blinn_exponent_scale == 1
                           ? ""
                           : words.format("figures.exponent_scale", scene.blinn_exponent_scale)) +
                      sphere_words(words, work.sphere),
                  table_head(with_error_heads(words, {words.text("figures.shininess")}, true)),
                  {},
                  {}};
    add_capture(figure, work, "exponents", draw_grid(scene, grid, options, work.draw.painters, "exponents", progress),
                grid_text(sidecar_text(scene, options, work.draw.by), grid));
    for (const std::string &value : grid.sweep.values) {
        Scene shiny = scene;
        shiny.objects.front().material.shininess = std::stod(value);
        const auto drawn = [&](std::size_t row) {
            return work.draw.picture(shiny, grid.techniques[row], options.size);
        };
        figure.table += table_row(with_error_cells({value}, compare(drawn(0), drawn(1), Flip::without)));
    }
    return figure;
}

Figure difference_figure(const FigureWork &work, const Progress &) {
    const Words &words = work.request.words;
    const auto &[left, right] = work.sides;
    PictureOptions options = pair_options(work, Layout::difference, work.request.view);
    options.samples = 1;
    options.difference_of = DifferenceOf::a_b;
    options.gain = fitting_gain(work.between.norms.max_abs);
    Figure figure{words.text("figures.difference"),
                  words.format("figures.difference.caption", title_of(words, left.technique),
                               title_of(words, right.technique), options.gain) +
                      warning(words, work.between),
                  table_head(with_error_heads(words, {words.text("figures.compared")}, true)) +
                      table_row(with_error_cells({words.text("figures.a_b")}, work.between)),
                  {},
                  {}};
    add_capture(figure, work, "difference", show_picture(work.request.scene, options, work.draw.painters),
                sidecar_text(work.request.scene, options, work.draw.by));
    if (can_be_compared(work)) {
        figure.commands.push_back(compare_command(work, to_string(left.technique), to_string(right.technique)));
    }
    return figure;
}

void check_figure_size(Size view) {
    if (view.width < least_side || view.height < least_side) {
        throw InputError("expected at least {0}x{0}, got {1}x{2}", least_side, view.width, view.height);
    }
    check_size({3 * view.width, 3 * view.height}); // more than any figure has, with its strips
}

std::vector<Figure> draw_figures(const FigureRequest &request, const FigureDraw &draw, const Progress &progress) {
    FigureWork work{request, draw, {side_of(request, draw, false), side_of(request, draw, true)}, {}, {}};
    work.between = compare(work.sides[0].drawn, work.sides[1].drawn, Flip::without);
    work.sphere = lone_sphere(request.scene, draw.load(request.scene));
    std::vector<Figure> figures;
    double done = 0;
    for (const FigureKind &kind : kinds) {
        figures.push_back(
            kind.make(work, [&](double share) { return !progress || progress(done + kind.share * share); }));
        done += kind.share;
        if (progress && !progress(done)) {
            throw Cancelled();
        }
    }
    return figures;
}

} // namespace sandbox
