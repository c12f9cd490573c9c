#pragma once

#include "image/image.h"
#include "measure/metrics/quantity.h"
#include "reference/reference.h"

#include <cstddef>
#include <optional>

/// How far one picture is from another, in linear colour and as the eye sees it.
namespace sandbox {

/// Over all three channels of the compared pixels, as differences of linear colour. All are infinite if either picture
/// holds a pixel that is not finite: no bound can then be met.
struct Norms {
    double rmse = 0;
    double mean_abs = 0;
    double max_abs = 0;
    double p99_abs = 0; ///< the smallest value that 99 % of the channels' differences do not exceed
};

constexpr std::string_view linear_color = "linear colour";
inline constexpr Quantity<Norms> norm_quantities[]{
    {"rmse", "RMSE", linear_color, "root mean square error", &Norms::rmse},
    {"mean_abs", "mean", linear_color, "mean error", &Norms::mean_abs},
    {"max_abs", "largest", linear_color, "largest error", &Norms::max_abs},
    {"p99_abs", "99th percentile", linear_color, "99th percentile of the error", &Norms::p99_abs},
};

/// The figures of `compare`: errors over the pixels where both pictures show the same object, except those at an edge
/// or at a jump of the reference; the rest is counted apart. Background is never compared.
struct Metrics {
    std::size_t nonfinite_pixels = 0; ///< in either picture, background included; anything above 0 is a failure
    std::size_t compared_pixels = 0;
    std::size_t silhouette_pixels = 0; ///< the two show different objects
    std::size_t edge_pixels = 0;       ///< same object, at an edge (ReferenceFrame::edge)
    std::size_t jump_pixels = 0;       ///< same object, not at an edge, at a jump (ReferenceFrame::jump)
    Norms norms;
    /// Where max_abs is, else the first that is not finite: y * width + x, row 0 at the top; 0 if nothing was compared.
    std::size_t worst_pixel = 0;
    std::optional<double> psnr; ///< dB, peak 1; none for identical pictures; -infinity if not finite
    int max_levels = 0;         ///< largest difference of the compared pixels in 8 bits, linear display
    double differing_share = 0; ///< share of the compared pixels that differ by a level or more
    double flip = 0;            ///< mean LDR FLIP of the whole pictures in 8 bits, linear display
};

/// The metrics that are no norms.
inline constexpr Quantity<Metrics> metric_quantities[]{
    {"psnr", "", "dB", "peak signal-to-noise ratio, peak 1; none where nothing differs", &Metrics::psnr},
    {"flip", "", "0 to 1", "mean FLIP of the whole pictures in 8 bits", &Metrics::flip, true},
    {"max_levels", "levels", "8-bit levels", "largest difference in 8 bits", &Metrics::max_levels},
    {"differing_share", "", "0 to 1", "share of the compared pixels that differ in 8 bits", &Metrics::differing_share},
    {"compared_pixels", "", "pixels", "pixels that count", &Metrics::compared_pixels},
    {"silhouette_pixels", "silhou&shy;ettes", "pixels", "left out: different objects", &Metrics::silhouette_pixels},
    {"edge_pixels", "edges", "pixels", "left out: at an edge between triangles", &Metrics::edge_pixels},
    {"jump_pixels", "jumps", "pixels", "left out: at a jump of the equation", &Metrics::jump_pixels},
    {"nonfinite_pixels", "not finite", "pixels", "NaN or infinite in either picture", &Metrics::nonfinite_pixels},
};
/// Calls `visit(row, its struct)` for every number, the norms first.
template <class M, class Visit> void for_each_metric(M &&metrics, Visit visit) {
    for (const Quantity<Norms> &norm : norm_quantities) {
        visit(norm, metrics.norms);
    }
    for (const Quantity<Metrics> &metric : metric_quantities) {
        visit(metric, metrics);
    }
}

/// FLIP costs more than all the rest together; left out, it is 0.
enum class Flip { with, without };

/// `left` is judged against `right`. Both must have the same size and object ids (std::invalid_argument otherwise).
Metrics compare(const Frame &left, const ReferenceFrame &right, Flip flip = Flip::with);
/// Two drawn pictures: no edges or jumps are known, so no pixel is counted as such.
Metrics compare(const Frame &left, const Frame &right);
/// Two truths: pixels at an edge or jump of either are left out.
Metrics compare(const ReferenceFrame &left, const ReferenceFrame &right);

/// Where an error comes from; each part over the pixels that its two pictures both show.
struct ErrorSplit {
    Norms interpolation;           ///< the technique in double against per-pixel in double, both on this mesh
    std::optional<Norms> geometry; ///< per-pixel in double on this mesh against the analytic surface; none without one
    Norms arithmetic;              ///< the float32 picture against the same technique in double
    Norms quantisation;            ///< the float32 picture, clamped to [0, 1], against its 8-bit levels
};
struct ErrorPart {
    std::string_view name;    ///< its key in JSON, the beginning of its columns in CSV
    std::string_view heading; ///< of its column on a page
    std::string_view meaning;
    std::variant<Norms ErrorSplit::*, std::optional<Norms> ErrorSplit::*> member;

    /// nullptr: `split` has no such part. Points into `split`.
    [[nodiscard]] const Norms *norms(const ErrorSplit &split) const {
        if (const auto *optional = std::get_if<std::optional<Norms> ErrorSplit::*>(&member)) {
            const std::optional<Norms> &part = split.**optional;
            return part ? &*part : nullptr;
        }
        return &(split.*std::get<Norms ErrorSplit::*>(member));
    }
    /// As tables show it: 0 where there is no such part.
    [[nodiscard]] double rmse(const ErrorSplit &split) const {
        const Norms *part = norms(split);
        return part != nullptr ? part->rmse : 0;
    }
};
inline constexpr ErrorPart error_parts[]{
    {"interpolation", "interpo&shy;lation", "interpolation", &ErrorSplit::interpolation},
    {"geometry", "geo&shy;metry", "geometry", &ErrorSplit::geometry},
    {"arithmetic", "arith&shy;metic", "float32 arithmetic", &ErrorSplit::arithmetic},
    {"quantisation", "quanti&shy;sation", "8-bit quantisation", &ErrorSplit::quantisation},
};

/// `geometry`: what an earlier call found for the same last two pictures; empty: it is computed.
ErrorSplit split_error(const Frame &drawn, const ReferenceFrame &technique, const ReferenceFrame &per_pixel,
                       const ReferenceFrame *analytic, const std::optional<Norms> &geometry = {});

} // namespace sandbox
