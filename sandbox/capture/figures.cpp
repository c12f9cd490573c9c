#include "capture/figures.h"

#include "capture/drawn_figures.h"
#include "capture/measured_figures.h"
#include "image/error.h"
#include "image/picture_size.h"
#include "measure/metrics/metrics.h"
#include "reference/reference.h"
#include "scene/mesh_factor.h"

#include <algorithm>

namespace sandbox {
namespace {

constexpr int least_side = 32;

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
    Technique truth = truth_of(side.technique, right ? request.pair.left : request.pair.right);
    truth.normalisation = side.technique.normalisation; // a factor of the model, no fault
    side.truth = render_reference(side.scene, draw.load(side.scene), truth, request.view);
    side.errors = compare(side.drawn, side.truth, Flip::without);
    return side;
}

} // namespace

void check_figure_size(Size view) {
    if (view.width < least_side || view.height < least_side) {
        throw InputError("expected at least {0}x{0}, got {1}x{2}", least_side, view.width, view.height);
    }
    check_size({5 * view.width / 2, 5 * std::max(view.width, view.height) / 4}); // of the subdivision series, about
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
