#include "teach/marking/judge.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace sandbox {
namespace {

/// A ratio says something only of light of at least so much: 1e-6 of rounding is then 5e-5 of it.
constexpr double least_light = 0.02;
/// ... and at so many pixels at least.
constexpr std::size_t least_pixels = 16;
/// A part that shows less light than so many tolerances, or whose factor never differs from 1 by that, proves nothing.
constexpr double telling = 3;

/// Of two programs that have one fault: what float32 decides otherwise where the fault, unlike the truth, has an edge,
/// and how their large numbers are rounded.
constexpr double line_strays = 0.01, relative_rounding = 1e-3;

bool finite(const glm::vec3 &v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
double largest(const glm::vec3 &v) {
    const glm::vec3 by = glm::abs(v);
    return static_cast<double>(std::max({by.x, by.y, by.z}));
}

/// The compared pixels of a part, as both sides have them.
struct Samples {
    std::vector<glm::vec3> answer, truth;
    std::vector<double> weight; ///< turns a difference into linear light
    std::vector<std::size_t> pixels;
    std::size_t nonfinite = 0; ///< of the answer; left out where it is forgiven
};

struct PairPictures {
    PairPictures(PictureStore &store, const Part::Pair &pair) : lit(store.of(pair.lit)), dark(store.of(pair.dark)) {}
    const Image &lit, &dark;
    [[nodiscard]] glm::vec3 at(std::size_t i) const { return glm::vec3(lit.pixels[i]) - glm::vec3(dark.pixels[i]); }
};

void add(Samples &samples, const Sides &sides, std::size_t pixel, const glm::vec3 &answer, const glm::vec3 &truth,
         double weight) {
    if (!finite(answer)) {
        ++samples.nonfinite;
        if (sides.forgives_nonfinite) {
            return;
        }
    }
    samples.answer.push_back(answer);
    samples.truth.push_back(truth);
    samples.weight.push_back(weight);
    samples.pixels.push_back(pixel);
}

Samples responses(const Part::Pair &pair, const Sides &sides) {
    const PairPictures answer(sides.answer, pair), truth(sides.truth, pair);
    const std::vector<std::uint8_t> &compared = sides.compared(pair.lit);
    Samples samples;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        if (compared[i] != 0) {
            add(samples, sides, i, answer.at(i), truth.at(i), 1);
        }
    }
    return samples;
}

Samples whole_pictures(const Scene &scene, const Sides &sides) {
    const Image &answer = sides.answer.of(scene), &truth = sides.truth.of(scene);
    const std::vector<std::uint8_t> &compared = sides.compared(scene);
    Samples samples;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        if (compared[i] != 0) {
            add(samples, sides, i, glm::vec3(answer.pixels[i]), glm::vec3(truth.pixels[i]), 1);
        }
    }
    return samples;
}

/// Of the channel whose light is strongest without the factor: the others have the same.
Samples ratios(const Part &part, const Sides &sides) {
    const PairPictures answer(sides.answer, part.shown), truth(sides.truth, part.shown);
    const PairPictures plain_answer(sides.answer, *part.plain), plain_truth(sides.truth, *part.plain);
    const std::vector<std::uint8_t> &compared = sides.compared(part.shown.lit);
    const std::vector<std::uint8_t> &compared_plain = sides.compared(part.plain->lit);
    Samples samples;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        if (compared[i] == 0 || compared_plain[i] == 0) {
            continue;
        }
        const glm::vec3 light = plain_truth.at(i), own = plain_answer.at(i);
        const int channel = light.x >= light.y && light.x >= light.z ? 0 : light.y >= light.z ? 1 : 2;
        if (std::abs(own[channel]) < least_light || light[channel] < least_light) {
            continue;
        }
        add(samples, sides, i, glm::vec3(answer.at(i)[channel] / own[channel]),
            glm::vec3(truth.at(i)[channel] / light[channel]), static_cast<double>(light[channel]));
    }
    return samples;
}

/// What both sides have, largest error first; the kind is left to who needs it.
Compared compared_samples(const Samples &samples, double tolerance) {
    Compared found;
    std::size_t showing = 0, wrong = 0;
    for (std::size_t i = 0; i < samples.answer.size(); ++i) {
        const double by = largest(samples.answer[i] - samples.truth[i]) * samples.weight[i];
        const double error = std::isfinite(by) ? by : INFINITY;
        const bool shows = !(largest(samples.answer[i]) * samples.weight[i] <= tolerance &&
                             largest(samples.truth[i]) * samples.weight[i] <= tolerance);
        showing += shows ? 1 : 0;
        wrong += error > tolerance ? 1 : 0;
        if (error > found.error) {
            found.error = error;
            found.pixel = samples.pixels[i];
            found.left = samples.answer[i];
            found.right = samples.truth[i];
        }
    }
    const auto strays = static_cast<std::size_t>(stray_share * static_cast<double>(showing));
    const bool too_few_finite = 2 * samples.nonfinite > samples.answer.size() + samples.nonfinite;
    found.state = wrong <= strays && !too_few_finite ? Compared::State::right : Compared::State::wrong;
    if (found.state == Compared::State::wrong) {
        found.kind = too_few_finite ? ErrorKind::not_finite : kind_of(samples.answer, samples.truth, tolerance);
    }
    return found;
}

/// Does the truth show what the part is about?
bool tells(const Samples &samples, bool ratio, bool decides, double tolerance) {
    if (ratio && samples.answer.size() < least_pixels) {
        return false;
    }
    for (std::size_t i = 0; i < samples.truth.size(); ++i) {
        const glm::vec3 shown = ratio && decides ? samples.truth[i] - glm::vec3(1) : samples.truth[i];
        if (largest(shown) * samples.weight[i] > telling * tolerance) {
            return true;
        }
    }
    return false;
}

class Judge {
  public:
    Judge(const Exercise &exercise, const Sides &sides) : exercise_(exercise), sides_(sides) {}

    Judgement judge() {
        // The dark picture is ambient's: whose diffuse or specular light does not heed its intensity shines in the
        // dark as well, and pays for that alone.
        for (const MarkTerm term : {MarkTerm::diffuse, MarkTerm::specular, MarkTerm::ambient, MarkTerm::attenuation,
                                    MarkTerm::cone, MarkTerm::normals}) {
            if (const TermPoints *row = exercise_.find(term)) {
                results_[static_cast<std::size_t>(term)] = judged(*row);
            }
        }
        if (const TermPoints *row = exercise_.find(MarkTerm::sum)) {
            results_[static_cast<std::size_t>(MarkTerm::sum)] = judged_sum(*row);
        }
        Judgement judgement;
        for (const TermPoints &row : exercise_.terms) {
            judgement.terms.push_back(row.term == MarkTerm::robustness ? robustness()
                                                                       : results_[static_cast<std::size_t>(row.term)]);
        }
        return judgement;
    }

  private:
    const Exercise &exercise_;
    const Sides &sides_;
    std::array<TermResult, term_count> results_{};

    [[nodiscard]] bool does_not_respond() const {
        return std::ranges::any_of(std::array{MarkTerm::diffuse, MarkTerm::specular}, [&](MarkTerm term) {
            const TermResult &result = results_[static_cast<std::size_t>(term)];
            return exercise_.find(term) != nullptr && result.worst && result.worst->kind == ErrorKind::unheeding;
        });
    }

    void note_worst(TermResult &result, double &most, const Compared &found, std::size_t scene) const {
        // An error that a student can look at is told first.
        const bool withheld = exercise_.scenes[scene].withheld;
        const double weight = std::min(found.error, 1e6) * (withheld ? 1e-9 : 1);
        if (!result.worst || weight > most) {
            most = weight;
            const auto width = static_cast<std::size_t>(exercise_.size.width);
            result.worst = {scene,
                            static_cast<int>(found.pixel % width),
                            static_cast<int>(found.pixel / width),
                            found.left,
                            found.right,
                            found.kind,
                            found.factor};
        }
    }

    TermResult judged(const TermPoints &row) const {
        TermResult result{row.term, 0, 0, {}, false};
        double most = 0;
        const bool forgive_dark = does_not_respond();
        for (const Unit &unit : units_of(exercise_, row.term)) {
            bool told = false, right = true;
            for (const Part &part : unit.parts) {
                const Compared found = compare_part(part, sides_, row.tolerance, forgive_dark);
                told = told || (part.decides && found.state != Compared::State::nothing) ||
                       found.state == Compared::State::wrong;
                if (found.state == Compared::State::wrong) {
                    right = false;
                    note_worst(result, most, found, unit.scene);
                }
            }
            result.units += told ? 1 : 0;
            result.right += told && right ? 1 : 0;
        }
        return result;
    }

    [[nodiscard]] bool all_right_so_far() const {
        return std::ranges::all_of(exercise_.terms, [&](const TermPoints &row) {
            return row.term == MarkTerm::sum || row.term == MarkTerm::robustness ||
                   results_[static_cast<std::size_t>(row.term)].is_right();
        });
    }

    /// The whole is the sum of its parts, whatever these are; where they are right, it is the truth.
    TermResult judged_sum(const TermPoints &row) const {
        TermResult result{MarkTerm::sum, 0, 0, {}, false};
        double most = 0;
        const bool all_right = all_right_so_far();
        for (const SumUnit &unit : sum_units_of(exercise_)) {
            const std::vector<std::uint8_t> &compared = sides_.compared(unit.whole);
            const Image &whole = sides_.answer.of(unit.whole), &dark = sides_.answer.of(unit.dark);
            std::vector<Samples> tests;
            for (const std::vector<Scene> &split : unit.splits) {
                std::vector<const Image *> parts;
                for (const Scene &scene : split) {
                    parts.push_back(&sides_.answer.of(scene));
                }
                tests.emplace_back();
                for (std::size_t i = 0; i < compared.size(); ++i) {
                    glm::vec3 sum(dark.pixels[i]);
                    for (const Image *part : parts) {
                        sum += glm::vec3(part->pixels[i]) - glm::vec3(dark.pixels[i]);
                    }
                    if (compared[i] != 0 && finite(sum)) {
                        add(tests.back(), sides_, i, glm::vec3(whole.pixels[i]), sum, 1);
                    }
                }
            }
            if (all_right) {
                tests.push_back(whole_pictures(unit.whole, sides_));
            }
            bool right = true;
            for (const Samples &test : tests) {
                // The sum of several pictures has the error of each.
                const Compared found = compared_samples(test, 2 * row.tolerance);
                if (found.state == Compared::State::wrong) {
                    right = false;
                    note_worst(result, most, found, unit.scene);
                }
            }
            const bool lit = shows_light(whole, dark, compared, row.tolerance);
            ++result.units;
            result.right += right && lit ? 1 : 0;
        }
        return result;
    }

    static bool shows_light(const Image &whole, const Image &dark, const std::vector<std::uint8_t> &compared,
                            double tolerance) {
        for (std::size_t i = 0; i < compared.size(); ++i) {
            const glm::vec3 by = glm::vec3(whole.pixels[i]) - glm::vec3(dark.pixels[i]);
            if (compared[i] != 0 && finite(by) && largest(by) > telling * tolerance) {
                return true;
            }
        }
        return false;
    }

    /// No pixel that is not finite in the stiff scenes, nor in what was drawn of the others; of light that is there.
    TermResult robustness() const {
        TermResult result{MarkTerm::robustness, 0, 0, {}, false};
        const bool lit = std::ranges::any_of(exercise_.terms, [&](const TermPoints &row) {
            return row.term != MarkTerm::robustness && results_[static_cast<std::size_t>(row.term)].right > 0;
        });
        if (!lit) {
            return result; // nothing is always finite
        }
        bool plain_is_finite = true;
        for (std::size_t i = 0; i < exercise_.scenes.size(); ++i) {
            const Image &picture = sides_.answer.of(exercise_.scenes[i].scene);
            const auto bad = std::ranges::find_if(picture.pixels, [](const glm::vec4 &p) { return !finite(p); });
            const bool good = bad == picture.pixels.end();
            const bool stiff = exercise_.scenes[i].stiff;
            plain_is_finite = plain_is_finite && (good || stiff);
            result.units += stiff ? 1 : 0;
            result.right += stiff && good ? 1 : 0;
            if (!good &&
                (!result.worst || (exercise_.scenes[result.worst->scene].withheld && !exercise_.scenes[i].withheld))) {
                const int pixel = static_cast<int>(bad - picture.pixels.begin());
                result.worst = {i,
                                pixel % exercise_.size.width,
                                pixel / exercise_.size.width,
                                glm::vec3(*bad),
                                glm::vec3(0),
                                ErrorKind::not_finite};
            }
        }
        result.right = plain_is_finite ? result.right : 0;
        return result;
    }
};

} // namespace

Compared compare_part(const Part &part, const Sides &sides, double tolerance, bool forgive_dark) {
    if (part.needs) {
        const Compared without = compared_samples(responses(*part.needs, sides), tolerance);
        if (without.state == Compared::State::wrong) {
            return {};
        }
    }
    const bool ratio = part.plain.has_value();
    const Samples samples = ratio ? ratios(part, sides) : responses(part.shown, sides);
    if (!tells(samples, ratio, part.decides, tolerance)) {
        // Light where the truth has none is wrong all the same.
        Compared found = compared_samples(samples, tolerance);
        found.factor = ratio;
        const bool wrong = found.state == Compared::State::wrong && (!ratio || samples.answer.size() >= least_pixels);
        return wrong ? found : Compared{};
    }
    Compared found = compared_samples(samples, tolerance);
    found.factor = ratio;
    if (ratio && found.kind == ErrorKind::missing) {
        found.kind = ErrorKind::too_dark; // no factor at all would be 1
    }
    if (!ratio && found.kind == ErrorKind::missing && found.state == Compared::State::wrong &&
        compared_samples(whole_pictures(part.shown.dark, sides), tolerance).state == Compared::State::wrong) {
        found.kind = ErrorKind::unheeding;
    }
    if (part.dark_too && !forgive_dark && found.state == Compared::State::right) {
        const Compared in_the_dark = compared_samples(whole_pictures(part.shown.dark, sides), tolerance);
        found = in_the_dark.state == Compared::State::wrong ? in_the_dark : found;
    }
    return found;
}

std::optional<bool> parts_agree(const Part &part, const Sides &sides, double tolerance) {
    const bool ratio = part.plain.has_value();
    const Samples samples = ratio ? ratios(part, sides) : responses(part.shown, sides);
    if (samples.answer.size() < least_pixels) {
        return std::nullopt;
    }
    std::size_t showing = 0, wrong = 0, shown_finite = 0;
    for (std::size_t i = 0; i < samples.answer.size(); ++i) {
        const glm::vec3 &a = samples.answer[i], &b = samples.truth[i];
        shown_finite += finite(a) && finite(b) ? 1 : 0;
        const double size = largest(b) * samples.weight[i];
        const bool same = finite(a) && finite(b)
                              ? largest(a - b) * samples.weight[i] <= tolerance + relative_rounding * size
                              : finite(a) == finite(b);
        wrong += same ? 0 : 1;
        showing += size > tolerance || !same ? 1 : 0;
    }
    if (2 * shown_finite < samples.answer.size()) {
        return std::nullopt; // one NaN is like another
    }
    return static_cast<double>(wrong) <= line_strays * static_cast<double>(showing);
}

Judgement judge(const Exercise &exercise, const Sides &sides) { return Judge(exercise, sides).judge(); }

double TermResult::share() const {
    return spared ? 1 : units == 0 ? 0 : static_cast<double>(right) / static_cast<double>(units);
}

double points_of(const TermPoints &term, const TermResult &result) {
    return std::round(100 * term.points * result.share()) / 100;
}

double Judgement::points(const Exercise &exercise) const {
    double sum = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        sum += points_of(exercise.terms[i], terms[i]);
    }
    return std::round(100 * sum) / 100;
}

TermResult *Judgement::find(MarkTerm term) {
    const auto found = std::ranges::find(terms, term, &TermResult::term);
    return found == terms.end() ? nullptr : &*found;
}

} // namespace sandbox
