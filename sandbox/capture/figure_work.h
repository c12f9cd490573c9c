#pragma once

#include "capture/figures.h"
#include "measure/report/plot_layout.h"
#include "scene/lone_sphere.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

/// What figures are made from, and how they say it.
namespace sandbox {

/// A side of the pair, one sample a pixel, as `compare --right reference` judges it.
struct FigureSide {
    Scene scene; ///< with the side's mesh factor
    Technique technique;
    Frame drawn;
    ReferenceFrame truth;
    Metrics errors;
};

struct FigureWork {
    const FigureRequest &request;
    const FigureDraw &draw;
    std::array<FigureSide, 2> sides;
    Metrics between; ///< A against B
    LoneSphere sphere;
};

/// A picture of `capture` and its sidecar, from which the command makes it again.
void add_capture(Figure &figure, const FigureWork &work, const std::string &name, const ByteImage &picture,
                 const std::string &sidecar);
/// A plot as NAME.svg and NAME.png; `plot` makes it in given words, as pictures may lack a Chinese font. One without a
/// point is left out, and the caption says so.
void add_plot(Figure &figure, const FigureWork &work, const std::string &name,
              const std::function<PlotRequest(const Words &)> &plot);

/// "a | b | c": a row of a table, whose first is its head.
std::string table_row(const std::vector<std::string> &cells);
std::string table_head(const std::vector<std::string> &heads);
/// The heads of with_error_cells(); `differences`: neither picture is the truth.
std::vector<std::string> with_error_heads(const Words &words, std::vector<std::string> heads, bool differences = false);
/// The largest error, in levels of 8 bits, RMSE, in levels.
std::vector<std::string> with_error_cells(std::vector<std::string> cells, const Metrics &metrics);
/// Why the errors say too little, as a sentence of its own; empty where they count.
std::string warning(const Words &words, const Metrics &metrics);
/// Which sphere it is, in sentences.
std::string sphere_words(const Words &words, const LoneSphere &sphere);

/// 1, 2 or 5 times a power of ten, so that `largest` comes near the end of a difference's scale; 1 for 0 and what is
/// not finite.
double fitting_gain(double largest);

/// "per vertex, Phong, mesh x 1/4"
std::string side_title(const FigureWork &work, const Words &words, bool right);

/// The pair's options, for a picture whose views together have the size `room`.
PictureOptions pair_options(const FigureWork &work, Layout layout, Size room);

} // namespace sandbox
