#include "measure/diagnosis/search.h"

#include "measure/metrics/metrics.h"
#include "reference/reference.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sandbox {
namespace {

constexpr int most_samples = 3000;
/// A candidate is ruled out if more than such a share of its samples differs by more than what is tolerated: the cheap
/// program rounds otherwise than the scene's own, and may take the other branch where the equation jumps.
constexpr double strict_share = 0.002, masked_share = 0.06;
constexpr std::size_t least_allowed = 3;
/// The cheap program decides about a tie where it leaves no doubt, so that no other has to be built: two numbers less
/// than a level apart are rounded to levels at most one apart, and two that are two levels apart to no fewer.
constexpr double surely_tied = 0.98, surely_apart = 2.02;
/// A reference is worked out for each candidate that is tried with masks.
constexpr std::size_t most_masked_tries = 6;

/// No other object, nor the background, in the 3 x 3 pixels around it: another program may draw outlines elsewhere.
PixelMask inside(const std::vector<std::uint32_t> &ids, Size size) {
    PixelMask mask(ids.size());
    const auto at = [&](int x, int y) {
        return ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)];
    };
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            bool same = at(x, y) != 0;
            for (int v = std::max(0, y - 1); v <= std::min(size.height - 1, y + 1); ++v) {
                for (int u = std::max(0, x - 1); u <= std::min(size.width - 1, x + 1); ++u) {
                    same = same && at(u, v) == at(x, y);
                }
            }
            mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)] =
                same ? 1 : 0;
        }
    }
    return mask;
}

struct Survivor {
    const Candidate *candidate;
    double rms;
};

/// Where a whole face lies just on the border of a gate, the cheap program errs all over it: the nearest of those that
/// were ruled out are tried all the same.
void keep_nearest(std::vector<Survivor> &survivors, std::vector<Survivor> ruled_out) {
    constexpr std::size_t some = 3;
    std::ranges::stable_sort(ruled_out, {}, &Survivor::rms);
    ruled_out.resize(std::min(ruled_out.size(), some));
    survivors.insert(survivors.end(), ruled_out.begin(), ruled_out.end());
}

} // namespace

Search::Search(const Scene &scene, const Observed &observed, const DiagnosisDraw &draw, std::function<void()> report)
    : scene_(scene), observed_(observed), draw_(draw), report_(std::move(report)),
      sampler_(draw, point_samples(observed.numbers.size, most_samples)), samples_(sampler_.samples()) {
    report_();
    // Every technique puts the same triangles in the same places; without a specular term the program is small.
    Technique plain;
    plain.model = Model::lambert;
    ids_ = draw_.picture(scene_, plain, samples_.full, true).object_ids;
    for (const std::uint32_t id : ids_) {
        shown_.push_back(id != 0 ? 1 : 0);
    }
    sampled_shown_ = sampled(shown_, samples_);
    sampled_inside_ = sampled(inside(ids_, samples_.full), samples_);
    sampled_count_ = static_cast<std::size_t>(std::ranges::count(sampled_shown_, 1));
}

const Levels &Search::observed(const Reading &reading, bool whole) {
    auto found = std::ranges::find(levels_, reading, &ObservedLevels::reading);
    if (found == levels_.end()) {
        Levels levels = observed_levels(observed_, reading);
        Levels some = sampled(levels, samples_, 3);
        found = levels_.insert(levels_.end(), {reading, std::move(levels), std::move(some)});
    }
    return whole ? found->whole : found->samples;
}

std::size_t Search::allowed(Strictness strictness) const {
    const double share = strictness == Strictness::everywhere ? strict_share : masked_share;
    return std::max(least_allowed, static_cast<std::size_t>(share * static_cast<double>(sampled_count_)));
}

Difference Search::sampled_difference(ScenePictures &pictures, const Technique &technique, const Reading &reading) {
    report_();
    ++drawn_;
    return difference_of(observed(reading, false), shown_levels(pictures.samples(technique), reading, observed_.bytes),
                         sampled_shown_, tolerated_levels);
}

PixelMask Search::masked_pixels(const ScenePictures &pictures, const Technique &technique) const {
    const ReferenceFrame truth =
        render_reference(pictures.scene(), draw_.load(pictures.scene()), technique, samples_.full);
    const std::vector<PixelUse> uses = pixel_uses(ids_, truth);
    PixelMask mask = inside(ids_, samples_.full);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        mask[i] = mask[i] != 0 && uses[i] == PixelUse::compared ? 1 : 0;
    }
    return mask;
}

std::vector<double> Search::power_rounding(const Scene &scene, const Technique &technique) {
    // The cosine that is raised comes from three vectors, each made unit and rounded, and a mirrored or half vector: it
    // errs by some 8 units of 2^-24. Its n-th power, and n log2 of it, err by n times that, relatively.
    constexpr double cosine_rounding = 8 * 0x1p-24;
    constexpr double least = 1e-4; // a fortieth of a level in white
    Scene shine = scene;
    shine.ambient = glm::dvec3(0);
    for (Light &light : shine.lights) {
        light.ambient = light.diffuse = 0;
    }
    std::vector<double> relative{0}; // of object ids
    for (Object &object : shine.objects) {
        object.material.emission = glm::dvec3(0);
        const double scale = reflection(technique.model).scaled_exponent ? scene.blinn_exponent_scale : 1;
        relative.push_back(cosine_rounding * scale * object.material.shininess);
    }
    if (!reflection(technique.model).specular || *std::ranges::max_element(relative) < least) {
        return {};
    }
    const auto image = ScenePictures(shine, sampler_).whole(technique);
    std::vector<double> rounding(ids_.size());
    for (std::size_t i = 0; image && i < rounding.size(); ++i) {
        const glm::vec4 &pixel = image->pixels[i];
        rounding[i] = 255 * relative[ids_[i]] * static_cast<double>(std::max({pixel.r, pixel.g, pixel.b}));
    }
    return rounding;
}

bool Search::within_rounding(const ScenePictures &pictures, const Technique &technique, const Levels &seen,
                             const Levels &drawn, const PixelMask &compared) {
    const std::vector<double> rounding = power_rounding(pictures.scene(), technique);
    for (std::size_t i = 0; i < 3 * rounding.size(); ++i) {
        const double by = std::abs(static_cast<double>(seen[i]) - static_cast<double>(drawn[i]));
        if (compared[i / 3] != 0 && !(by <= tolerated_levels + rounding[i / 3])) {
            return false;
        }
    }
    return !rounding.empty();
}

bool Search::hopeless_beside_masks(const ScenePictures &pictures, const Technique &technique, const Reading &reading) {
    // The samples' pixels are larger, and so are their masks.
    const ReferenceFrame truth =
        render_reference(pictures.sampled_scene(), draw_.load(pictures.sampled_scene()), technique, samples_.size);
    const std::vector<PixelUse> uses = pixel_uses(sampled(ids_, samples_), truth);
    PixelMask mask = sampled_inside_;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        mask[i] = mask[i] != 0 && uses[i] == PixelUse::compared ? 1 : 0;
    }
    // The picture tried may itself be a level from the one in double.
    return difference_of(observed(reading, false), shown_levels(to_frame(truth).color, reading, observed_.bytes), mask,
                         2 * tolerated_levels)
               .over > least_allowed;
}

std::optional<Found> Search::explain(ScenePictures &pictures, const std::vector<Candidate> &candidates,
                                     const Reading &reading, Strictness strictness,
                                     const std::vector<Convention> &conventions) {
    const bool masked = strictness == Strictness::masked;
    std::vector<Survivor> survivors;
    std::vector<Survivor> ruled_out;
    for (const Candidate &candidate : candidates) {
        const Difference whole = sampled_difference(pictures, candidate.technique, reading);
        if (whole.compared == 0) {
            continue;
        }
        if (!nearest_ || whole.rms < nearest_->rms) {
            nearest_ = {candidate.technique, reading, pictures.scene(), conventions, whole.rms};
        }
        const std::size_t over =
            !masked ? whole.over
                    : difference_of(observed(reading, false),
                                    shown_levels(pictures.samples(candidate.technique), reading, observed_.bytes),
                                    sampled_inside_, tolerated_levels)
                          .over;
        if (over <= allowed(strictness)) {
            survivors.push_back({&candidate, whole.rms});
        } else if (2 * over < whole.compared) {
            ruled_out.push_back({&candidate, whole.rms});
        }
    }
    if (!masked && conventions.empty() && reading == Reading{}) {
        keep_nearest(survivors, ruled_out);
    }
    std::ranges::stable_sort(survivors, [](const Survivor &a, const Survivor &b) {
        return a.candidate->faults != b.candidate->faults ? a.candidate->faults < b.candidate->faults : a.rms < b.rms;
    });
    if (masked && survivors.size() > most_masked_tries) {
        survivors.resize(most_masked_tries);
    }
    for (const auto &[candidate, rms] : survivors) {
        report_();
        if (masked && hopeless_beside_masks(pictures, candidate->technique, reading)) {
            continue;
        }
        const auto image = pictures.whole(candidate->technique);
        if (!image) {
            continue;
        }
        PixelMask compared = masked ? masked_pixels(pictures, candidate->technique) : shown_;
        const Levels drawn = shown_levels(*image, reading, observed_.bytes);
        const Difference residual = difference_of(observed(reading, true), drawn, compared, tolerated_levels);
        const auto shown = static_cast<double>(std::ranges::count(shown_, 1));
        const bool explained =
            residual.largest <= tolerated_levels ||
            (masked && reading.encoding == Encoding::linear &&
             within_rounding(pictures, candidate->technique, observed(reading, true), drawn, compared));
        if (explained && static_cast<double>(residual.compared) >= trusted_share * shown) {
            return Found{candidate->technique, candidate->same, candidate->faults, residual, std::move(compared)};
        }
    }
    return std::nullopt;
}

std::vector<Technique> Search::ties(ScenePictures &pictures, const std::vector<Candidate> &candidates,
                                    const Found &found, const Reading &reading) {
    // Samples in double and of a program may be a level apart by rounding.
    const PixelMask compared = sampled(found.compared, samples_);
    const Levels some = shown_levels(pictures.samples(found.technique), reading, true);
    std::vector<const Candidate *> close;
    for (const Candidate &candidate : candidates) {
        report_();
        if (candidate.technique == found.technique ||
            difference_of(some, shown_levels(pictures.samples(candidate.technique), reading, true), compared,
                          2 * tolerated_levels)
                    .over <= allowed(Strictness::everywhere)) {
            close.push_back(&candidate);
        }
    }
    Reading clamping = reading;
    clamping.clamped = true;
    // A few programs of their own are built sooner than the one for all of a frequency.
    const auto worth_building = [&](const Technique &technique) {
        constexpr std::ptrdiff_t few = 3;
        return std::ranges::count_if(close, [&](const Candidate *candidate) {
                   return candidate->technique.frequency == technique.frequency;
               }) > few;
    };
    std::optional<Levels> cheap_found;
    if (std::ranges::any_of(close, [&](const Candidate *c) { return worth_building(c->technique); })) {
        if (const auto image = pictures.cheap_whole(found.technique)) {
            cheap_found = shown_levels(*image, clamping, false);
        }
    }
    const Levels whole = shown_levels(pictures.whole(found.technique).value(), reading, true);
    const auto is_tied = [&](const Technique &technique) {
        if (technique == found.technique) {
            return true;
        }
        const bool cheaply = cheap_found && worth_building(technique);
        if (const auto cheap = cheaply ? pictures.cheap_whole(technique) : std::nullopt) {
            const Levels levels = shown_levels(*cheap, clamping, false);
            if (difference_of(*cheap_found, levels, found.compared, 0).largest <= surely_tied) {
                return true;
            }
            if (difference_of(*cheap_found, levels, found.compared, surely_apart).over > least_allowed) {
                return false;
            }
        }
        const auto other = pictures.whole(technique);
        return other &&
               difference_of(whole, shown_levels(*other, reading, true), found.compared, 0).largest <= tolerated_levels;
    };
    std::vector<Technique> tied;
    for (const Candidate *candidate : close) {
        report_();
        if (is_tied(candidate->technique)) {
            std::ranges::copy_if(candidate->same, std::back_inserter(tied),
                                 [&](const Technique &t) { return t != found.technique; });
        }
    }
    return tied;
}

bool Search::may_explain(const Equations &equations, const std::vector<double> &light, const Reading &reading) {
    const Levels &levels = observed(reading, false);
    std::size_t over = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double level = 255 * encoded(light[i], reading.encoding);
        over += std::abs(level - static_cast<double>(levels[equations.values[i]])) > 2 * tolerated_levels ? 1 : 0;
    }
    return over <= 3 * allowed(Strictness::masked); // three channels a sample
}

Search::Equations Search::equations(const Reading &reading) const {
    Equations equations;
    Levels levels = sampled(observed_levels(observed_, reading), samples_, 3);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const bool cut = (observed_.bytes || reading.clamped) && levels[i] >= 254.5F;
        if (sampled_inside_[i / 3] != 0 && std::isfinite(levels[i]) && !cut) {
            equations.values.push_back(i);
            equations.light.push_back(decoded(static_cast<double>(levels[i]) / 255, reading.encoding));
        }
    }
    return equations;
}

} // namespace sandbox
