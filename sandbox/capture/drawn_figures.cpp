#include "capture/drawn_figures.h"

#include "capture/grid.h"
#include "words/row_words.h"

#include <array>
#include <fmt/format.h>

namespace sandbox {
namespace {

constexpr int samples = 4; ///< a pixel of pictures that nothing is measured in
constexpr std::array<std::string_view, 4> exponents{"2", "8", "32", "128"};

std::string compare_command(const FigureWork &work, const std::string &left, const std::string &right) {
    const FigureRequest &request = work.request;
    return fmt::format("shading-sandbox compare {}{} --left {} --right {} --size {}x{}", request.scene_arguments,
                       request.common_arguments, left, right, request.view.width, request.view.height);
}

/// `compare` knows no mesh factors.
bool can_be_compared(const FigureWork &work) { return work.request.pair.mesh_factors == MeshFactors{1, 1}; }

} // namespace

Figure pair_figure(const FigureWork &work, const Progress &) {
    const Words &words = work.request.words;
    const auto &[left, right] = work.sides;
    const Size view = work.request.view;
    PictureOptions options = pair_options(work, Layout::side_by_side, {2 * view.width, view.height});
    options.samples = samples;
    const std::string of_left = warning(words, left.errors), of_right = warning(words, right.errors);
    const std::string warnings = of_left + (of_right == of_left ? "" : of_right);
    Figure figure{words.text("figures.pair"),
                  words.format("figures.pair.caption", side_title(work, words, false), side_title(work, words, true),
                               view.width, view.height, samples) +
                      warnings,
                  table_head(with_error_heads(words, {words.text("figures.compared")})),
                  {},
                  {}};
    add_capture(figure, work, "pair", show_picture(work.request.scene, options, work.draw.painters),
                sidecar_text(work.request.scene, options, work.draw.by, work.request.out));
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
                grid_text(sidecar_text(scene, options, work.draw.by, work.request.out), grid, work.request.out));
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
                  words.format("figures.difference.caption", side_title(work, words, false),
                               side_title(work, words, true), options.gain) +
                      warning(words, work.between),
                  table_head(with_error_heads(words, {words.text("figures.compared")}, true)) +
                      table_row(with_error_cells({words.text("figures.a_b")}, work.between)),
                  {},
                  {}};
    add_capture(figure, work, "difference", show_picture(work.request.scene, options, work.draw.painters),
                sidecar_text(work.request.scene, options, work.draw.by, work.request.out));
    if (can_be_compared(work)) {
        figure.commands.push_back(compare_command(work, to_string(left.technique), to_string(right.technique)));
    }
    return figure;
}

} // namespace sandbox
