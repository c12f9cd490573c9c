#pragma once

#include "image/image.h"
#include "measure/metrics/quantity.h"
#include "reference/reference.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// How far one picture is from another, in linear colour and as the eye sees it.
namespace sandbox {

/// Over all three channels of the compared pixels, as differences of linear colour. All are infinite if either picture
/// holds a pixel that is not finite, and NaN if nothing was compared: no bound can then be met.
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

constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();

/// The figures of `compare`: errors over the pixels where both pictures show the same object, except those that a mask
/// of the reference leaves out. A masked pixel counts once, under the first of the four causes. Background (in both
/// pictures) counts nowhere.
struct Metrics {
    std::size_t nonfinite_pixels = 0; ///< in either picture, background included; anything above 0 is a failure
    std::size_t compared_pixels = 0;
    double compared_share = unmeasured; ///< compared / (compared + masked); NaN where neither shows an object
    std::size_t silhouette_pixels = 0;  ///< the two show different objects
    std::size_t edge_pixels = 0;        ///< at an edge (ReferenceFrame::edge)
    std::size_t jump_pixels = 0;        ///< at a jump (ReferenceFrame::jump)
    std::size_t rounding_pixels = 0;    ///< rounding alone decides (ReferenceFrame::rounding)
    /// The largest difference of a channel under each mask; NaN where the mask is empty.
    double silhouette_max_abs = unmeasured, edge_max_abs = unmeasured, jump_max_abs = unmeasured,
           rounding_max_abs = unmeasured;
    Norms norms;
    /// Where max_abs is, else the first that is not finite: y * width + x, row 0 at the top; 0 if nothing was compared.
    std::size_t worst_pixel = 0;
    /// dB, peak 1; none for identical pictures; -infinity if not finite, NaN if nothing was compared
    std::optional<double> psnr;
    std::optional<int> max_levels = 0; ///< largest difference of the compared pixels in 8 bits, linear display
    double differing_share = 0;        ///< share of the compared pixels that differ by a level or more
    double flip = 0;                   ///< mean LDR FLIP of the whole pictures in 8 bits, linear display
};

/// What becomes of a pixel.
enum class PixelUse : std::uint8_t { background, compared, silhouette, edge, jump, rounding };
/// The causes for which a pixel is left out, in the order in which they are asked.
struct Mask {
    PixelUse use;
    std::string_view name, meaning;
    std::size_t Metrics::*pixels;
    double Metrics::*max_abs;
    std::array<std::uint8_t, 3> color; ///< in pictures of the masks; told apart by colour-blind eyes, too
};
inline constexpr Mask masks[]{
    {PixelUse::silhouette,
     "silhouette",
     "different objects",
     &Metrics::silhouette_pixels,
     &Metrics::silhouette_max_abs,
     {255, 80, 220}},
    {PixelUse::edge,
     "edge",
     "at an edge between triangles",
     &Metrics::edge_pixels,
     &Metrics::edge_max_abs,
     {255, 230, 50}},
    {PixelUse::jump,
     "jump",
     "at a jump of the equation",
     &Metrics::jump_pixels,
     &Metrics::jump_max_abs,
     {255, 110, 30}},
    {PixelUse::rounding,
     "rounding",
     "float32 rounding alone decides",
     &Metrics::rounding_pixels,
     &Metrics::rounding_max_abs,
     {60, 190, 255}},
};

/// Figures count only where at least this share of what the pictures show is compared.
constexpr double trusted_share = 0.5;
/// Why the norms say too little, in words; empty where they count.
std::string why_untrusted(const Metrics &metrics);

/// The metrics that are no norms.
inline constexpr Quantity<Metrics> metric_quantities[]{
    {"psnr", "", "dB", "peak signal-to-noise ratio, peak 1; none where nothing differs", &Metrics::psnr},
    {"flip", "", "0 to 1", "mean FLIP of the whole pictures in 8 bits", &Metrics::flip, true},
    {"max_levels", "levels", "8-bit levels", "largest difference in 8 bits", &Metrics::max_levels},
    {"differing_share", "", "0 to 1", "share of the compared pixels that differ in 8 bits", &Metrics::differing_share},
    {"compared_pixels", "", "pixels", "pixels that count", &Metrics::compared_pixels},
    {"compared_share", "com&shy;pared", "0 to 1", "share of the pixels that show an object and count",
     &Metrics::compared_share},
    {"silhouette_pixels", "silhou&shy;ettes", "pixels", "left out: different objects", &Metrics::silhouette_pixels},
    {"edge_pixels", "edges", "pixels", "left out: at an edge between triangles", &Metrics::edge_pixels},
    {"jump_pixels", "jumps", "pixels", "left out: at a jump of the equation", &Metrics::jump_pixels},
    {"rounding_pixels", "round&shy;ing", "pixels", "left out: rounding alone decides", &Metrics::rounding_pixels},
    {"silhouette_max_abs", "", linear_color, "largest error at silhouettes", &Metrics::silhouette_max_abs},
    {"edge_max_abs", "", linear_color, "largest error at edges", &Metrics::edge_max_abs},
    {"jump_max_abs", "", linear_color, "largest error at jumps", &Metrics::jump_max_abs},
    {"rounding_max_abs", "", linear_color, "largest error where rounding decides", &Metrics::rounding_max_abs},
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
/// Two drawn pictures: no masks are known but silhouettes.
Metrics compare(const Frame &left, const Frame &right, Flip flip = Flip::with);
/// Two truths: what a mask of either covers is left out.
Metrics compare(const ReferenceFrame &left, const ReferenceFrame &right, Flip flip = Flip::with);

/// What becomes of each pixel of the first comparison; a drawn picture gives its object ids alone.
std::vector<PixelUse> pixel_uses(const std::vector<std::uint32_t> &left_ids, const ReferenceFrame &right);

/// The picture in dim grey, masked pixels in their cause's colour. `shown` and `uses` have the same pixels.
ByteImage mask_picture(const ByteImage &shown, const std::vector<PixelUse> &uses);

/// Sets what the counts of pixels decide: compared_share, and every figure of a picture that is not finite or of which
/// nothing is compared. Files write these alike, as null.
void settle(Metrics &metrics);

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
