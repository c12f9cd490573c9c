#include "measure/metrics/metrics.h"

#include "image/thread.h"
#include "measure/metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

namespace sandbox {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr Norms not_finite{infinite, infinite, infinite, infinite};
constexpr Norms nothing_compared{unmeasured, unmeasured, unmeasured, unmeasured};

bool finite(const glm::dvec3 &c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }

/// Reads a drawn picture and a truth alike.
class Reading {
  public:
    explicit Reading(const Frame &frame) : frame_(&frame), size_(frame.color.size), ids_(&frame.object_ids) {}
    explicit Reading(const ReferenceFrame &truth) : truth_(&truth), size_(truth.size), ids_(&truth.object_ids) {}

    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] std::size_t pixels() const {
        return static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
    }
    [[nodiscard]] bool has_ids() const { return ids_->size() == pixels(); }
    [[nodiscard]] glm::dvec3 color(std::size_t i) const {
        return frame_ != nullptr ? glm::dvec3(frame_->color.pixels[i]) : truth_->color[i];
    }
    [[nodiscard]] std::uint32_t id(std::size_t i) const { return (*ids_)[i]; }
    /// Does this mask of a truth cover the pixel, of which both pictures show the same object?
    [[nodiscard]] bool masked(std::vector<std::uint8_t> ReferenceFrame::*mask, std::size_t i) const {
        const bool rival = mask == &ReferenceFrame::edge && truth_ != nullptr && truth_->rival[i] != 0;
        return truth_ != nullptr && (truth_->*mask)[i] != 0 && !rival;
    }
    [[nodiscard]] ByteImage display() const {
        return to_display(frame_ != nullptr ? frame_->color : to_frame(*truth_).color, Display::linear);
    }

  private:
    const Frame *frame_ = nullptr;
    const ReferenceFrame *truth_ = nullptr;
    Size size_;
    const std::vector<std::uint32_t> *ids_;
};

void require_alike(const Reading &left, const Reading &right) {
    if (!(left.size() == right.size())) {
        throw std::invalid_argument("compare: the pictures differ in size");
    }
    if (!left.has_ids() || !right.has_ids()) {
        throw std::invalid_argument("compare: both pictures need object ids");
    }
}

/// Differences of linear colour, a channel each.
class Differences {
  public:
    explicit Differences(std::size_t pixels) { values_.reserve(3 * pixels); }
    void add(const glm::dvec3 &difference) {
        for (int channel = 0; channel < 3; ++channel) {
            values_.push_back(std::abs(difference[channel]));
        }
    }

    /// Loses the order of the values.
    [[nodiscard]] Norms norms() {
        if (values_.empty()) {
            return nothing_compared;
        }
        Norms norms;
        double sum = 0;
        double squares = 0;
        for (const double value : values_) {
            sum += value;
            squares += value * value;
            norms.max_abs = std::max(norms.max_abs, value);
        }
        const auto count = static_cast<double>(values_.size());
        norms.mean_abs = sum / count;
        norms.rmse = std::sqrt(squares / count);
        const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.99 * count)) - 1;
        std::nth_element(values_.begin(), values_.begin() + rank, values_.end());
        norms.p99_abs = values_[static_cast<std::size_t>(rank)];
        return norms;
    }

  private:
    std::vector<double> values_;
};

/// The first cause that applies.
PixelUse use_of(const Reading &left, const Reading &right, std::size_t i) {
    const auto masked = [&](auto mask) { return left.masked(mask, i) || right.masked(mask, i); };
    if (left.id(i) != right.id(i)) {
        return PixelUse::silhouette;
    }
    if (left.id(i) == 0) {
        return PixelUse::background;
    }
    if (masked(&ReferenceFrame::edge)) {
        return PixelUse::edge;
    }
    if (masked(&ReferenceFrame::jump)) {
        return PixelUse::jump;
    }
    return masked(&ReferenceFrame::rounding) ? PixelUse::rounding : PixelUse::compared;
}

double largest_difference(const Reading &left, const Reading &right, std::size_t i) {
    const glm::dvec3 difference = glm::abs(left.color(i) - right.color(i));
    return std::max({difference.x, difference.y, difference.z});
}

/// Finds the pixels to compare; counts the others, with the largest error under each mask.
std::vector<std::size_t> compared_pixels(const Reading &left, const Reading &right, Metrics &metrics) {
    std::vector<std::size_t> compared;
    compared.reserve(left.pixels());
    for (std::size_t i = 0; i < left.pixels(); ++i) {
        if ((!finite(left.color(i)) || !finite(right.color(i))) && metrics.nonfinite_pixels++ == 0) {
            metrics.worst_pixel = i;
        }
        const PixelUse use = use_of(left, right, i);
        if (use == PixelUse::compared) {
            compared.push_back(i);
        }
        const auto mask = std::ranges::find(masks, use, &Mask::use);
        if (mask != std::end(masks)) {
            ++(metrics.*mask->pixels);
            double &most = metrics.*mask->max_abs;
            most = std::fmax(most, largest_difference(left, right, i)); // which drops NaN
        }
    }
    metrics.compared_pixels = compared.size();
    return compared;
}

Norms norms_of(const Reading &left, const Reading &right, const std::vector<std::size_t> &compared) {
    Differences differences(compared.size());
    for (const std::size_t i : compared) {
        differences.add(left.color(i) - right.color(i));
    }
    return differences.norms();
}

std::size_t worst_of(const Reading &left, const Reading &right, const std::vector<std::size_t> &compared) {
    const auto error = [&](std::size_t i) { return largest_difference(left, right, i); };
    return compared.empty() ? 0 : *std::ranges::max_element(compared, {}, error);
}

/// max_levels, differing_share and flip: what 8 bits and the eye see.
void compare_displayed(const Reading &left, const Reading &right, const std::vector<std::size_t> &compared, Flip flip,
                       Metrics &metrics) {
    const ByteImage a = left.display();
    const ByteImage b = right.display();
    std::size_t differing = 0;
    int most = 0;
    for (const std::size_t i : compared) {
        int levels = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            levels = std::max(levels, std::abs(a.rgb[3 * i + channel] - b.rgb[3 * i + channel]));
        }
        differing += levels > 0 ? 1 : 0;
        most = std::max(most, levels);
    }
    metrics.max_levels = most;
    metrics.differing_share = static_cast<double>(differing) / static_cast<double>(compared.size());
    metrics.flip = flip == Flip::with ? mean_flip(a, b) : 0;
}

Metrics compare_views(const Reading &left, const Reading &right, Flip flip) {
    require_alike(left, right);
    let_others_run();
    Metrics metrics;
    const std::vector<std::size_t> compared = compared_pixels(left, right, metrics);
    if (metrics.nonfinite_pixels == 0) {
        metrics.norms = norms_of(left, right, compared);
        metrics.worst_pixel = worst_of(left, right, compared);
    }
    let_others_run();
    if (metrics.norms.rmse > 0) {
        metrics.psnr = -20 * std::log10(metrics.norms.rmse);
    }
    compare_displayed(left, right, compared, flip, metrics);
    settle(metrics);
    return metrics;
}

Norms norms_between(const Reading &left, const Reading &right) {
    require_alike(left, right);
    Metrics counts;
    const std::vector<std::size_t> compared = compared_pixels(left, right, counts);
    return counts.nonfinite_pixels > 0 ? not_finite : norms_of(left, right, compared);
}

Norms quantisation_of(const Frame &drawn) {
    const Reading view(drawn);
    Differences differences(view.pixels());
    for (std::size_t i = 0; i < view.pixels(); ++i) {
        if (!finite(view.color(i))) {
            return not_finite;
        }
        if (view.id(i) != 0) {
            const glm::dvec3 shown = glm::clamp(view.color(i), 0.0, 1.0);
            differences.add(glm::round(shown * 255.0) / 255.0 - shown);
        }
    }
    return differences.norms();
}

} // namespace

void settle(Metrics &metrics) {
    std::size_t masked = 0;
    for (const Mask &mask : masks) {
        masked += metrics.*mask.pixels;
        if (metrics.nonfinite_pixels > 0 && metrics.*mask.pixels > 0) {
            metrics.*mask.max_abs = infinite;
        }
    }
    const auto shown = static_cast<double>(metrics.compared_pixels + masked);
    metrics.compared_share = shown > 0 ? static_cast<double>(metrics.compared_pixels) / shown : unmeasured;
    if (metrics.compared_pixels == 0) {
        metrics.norms = nothing_compared;
        metrics.psnr = unmeasured;
        metrics.max_levels.reset();
        metrics.differing_share = unmeasured;
    }
    if (metrics.nonfinite_pixels > 0) {
        metrics.norms = not_finite;
        metrics.psnr = -infinite;
    }
}

std::string why_untrusted(const Metrics &metrics) {
    const bool nothing = std::isnan(metrics.norms.rmse);
    if (!nothing && !(metrics.compared_share < trusted_share)) {
        return {};
    }
    std::size_t shown = metrics.compared_pixels;
    std::string causes;
    for (const Mask &mask : masks) {
        const std::size_t pixels = metrics.*mask.pixels;
        shown += pixels;
        causes += pixels > 0 ? fmt::format("{}{} {}", causes.empty() ? "" : ", ", mask.name, pixels) : "";
    }
    return shown == 0 ? "neither picture shows an object"
                      : fmt::format("{} of the {} pixels that show an object are compared; left out: {}",
                                    metrics.compared_pixels == 0 ? "none" : fmt::format("{}", metrics.compared_pixels),
                                    shown, causes);
}

std::vector<PixelUse> pixel_uses(const std::vector<std::uint32_t> &left_ids, const ReferenceFrame &right) {
    Frame left;
    left.color.size = right.size;
    left.object_ids = left_ids;
    const Reading drawn(left);
    const Reading truth(right);
    require_alike(drawn, truth);
    std::vector<PixelUse> uses;
    for (std::size_t i = 0; i < drawn.pixels(); ++i) {
        uses.push_back(use_of(drawn, truth, i));
    }
    return uses;
}

ByteImage mask_picture(const ByteImage &shown, const std::vector<PixelUse> &uses) {
    ByteImage picture = shown;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const auto rgb = picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i);
        const auto mask = std::ranges::find(masks, uses[i], &Mask::use);
        if (mask != std::end(masks)) {
            std::ranges::copy(mask->color, rgb);
        } else {
            std::fill_n(rgb, 3, static_cast<std::uint8_t>((rgb[0] + rgb[1] + rgb[2]) / 6)); // half of its mean
        }
    }
    return picture;
}

Metrics compare(const Frame &left, const ReferenceFrame &right, Flip flip) {
    return compare_views(Reading(left), Reading(right), flip);
}
Metrics compare(const Frame &left, const Frame &right, Flip flip) {
    return compare_views(Reading(left), Reading(right), flip);
}
Metrics compare(const ReferenceFrame &left, const ReferenceFrame &right, Flip flip) {
    return compare_views(Reading(left), Reading(right), flip);
}

ErrorSplit split_error(const Frame &drawn, const ReferenceFrame &technique, const ReferenceFrame &per_pixel,
                       const ReferenceFrame *analytic, const std::optional<Norms> &geometry) {
    ErrorSplit split{{}, geometry, {}, {}};
    parallel_for(4, [&](std::size_t part) {
        switch (part) {
        case 0:
            if (&technique != &per_pixel) {
                split.interpolation = norms_between(Reading(technique), Reading(per_pixel));
            }
            break;
        case 1:
            if (analytic != nullptr && !geometry) {
                split.geometry = norms_between(Reading(per_pixel), Reading(*analytic));
            }
            break;
        case 2:
            split.arithmetic = norms_between(Reading(drawn), Reading(technique));
            break;
        default:
            split.quantisation = quantisation_of(drawn);
            break;
        }
    });
    return split;
}

} // namespace sandbox
