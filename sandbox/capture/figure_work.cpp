#include "capture/figure_work.h"

#include "capture/labels.h"
#include "capture/plot_picture.h"
#include "image/png.h"
#include "measure/report/svg.h"
#include "measure/report/text.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sandbox {

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
    return why.empty() ? "" : words.format("figures.untrusted", why);
}

std::string side_title(const FigureWork &work, const Words &words, bool right) {
    return title_of(words, work.sides[right ? 1 : 0].technique) +
           mesh_factor_note(words, work.request.pair.mesh_factors[right ? 1 : 0]);
}

std::string sphere_words(const Words &words, const LoneSphere &sphere) {
    const std::string name = sphere.of.empty() ? words.text("figures.unnamed") : file_text(words, sphere.of);
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

} // namespace sandbox
