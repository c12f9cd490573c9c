#include "measure/diagnosis/diagnosis.h"

#include "image/error.h"
#include "measure/diagnosis/light_search.h"
#include "measure/diagnosis/search.h"
#include "measure/metrics/metrics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

namespace sandbox {
namespace {

/// Two faults are sought under so many frequencies and models, the nearest.
constexpr std::size_t most_bases = 3;

class Diagnostician {
  public:
    Diagnostician(const DiagnosisRequest &request, const DiagnosisDraw &draw, const Progress &progress)
        : request_(request), draw_(draw), progress_(progress),
          search_(request.scene, request.observed, draw, [this] { report(); }),
          bases_(base_techniques(request.technique)), resources_(draw.load(request.scene)),
          plain_(std::make_shared<ScenePictures>(request.scene, search_.sampler())),
          singles_(single_candidates(request.scene, resources_, bases_)),
          light_(plain_, resources_, search_, [this] { report(); }) {}

    Diagnosis diagnose() {
        Diagnosis diagnosis;
        if (const auto explanation = explain()) {
            tell(*explanation, diagnosis);
        } else {
            tell_nearest(diagnosis);
        }
        diagnosis.shown_pixels = static_cast<std::size_t>(std::ranges::count(search_.shown(), 1));
        diagnosis.candidates = search_.drawn();
        return diagnosis;
    }

  private:
    void report() {
        ++steps_;
        constexpr double usual = 1500; // of a picture that needs two faults
        const double done = static_cast<double>(steps_) / (static_cast<double>(steps_) + usual);
        if (progress_ && !progress_(done)) {
            throw Cancelled();
        }
    }

    /// Fewest assumptions first: one fault, however the numbers are written; other light; two faults.
    std::optional<Explanation> explain() {
        if (std::ranges::count(search_.shown(), 1) == 0) {
            return std::nullopt;
        }
        if (auto explanation = explain_by_one(Strictness::everywhere)) {
            return explanation;
        }
        if (auto explanation = explain_by_one(Strictness::masked)) {
            // A second fault may hide under the masks: if it explains every pixel, it is owed.
            auto two = explain_by_two({base_of(explanation->found.technique)}, Strictness::everywhere);
            return two ? two : explanation;
        }
        if (auto explanation = explain_by_light(bases_, 0, one_change, {Strictness::everywhere, Strictness::masked})) {
            return nearer_by_two(std::move(*explanation));
        }
        return explain_by_more();
    }

    /// Two faults, or one under other light; then light with several factors, which fit more than they explain.
    std::optional<Explanation> explain_by_more() {
        const std::vector<Technique> nearest = nearest_bases();
        const std::vector<Technique> some(nearest.begin(),
                                          nearest.begin() + std::min<std::ptrdiff_t>(std::ssize(nearest), 2));
        for (const Strictness strictness : {Strictness::everywhere, Strictness::masked}) {
            if (auto explanation = explain_by_two(nearest, strictness)) {
                return explanation;
            }
            if (auto explanation = explain_by_light(some, 1, one_change, {strictness})) {
                return explanation;
            }
            if (auto explanation = explain_by_light(bases_, 0, several_changes, {strictness})) {
                return explanation;
            }
            if (auto explanation = explain_by_light(some, 1, several_changes, {strictness})) {
                return explanation;
            }
        }
        return std::nullopt;
    }

    /// Two faults may look like a term that is weaker or missing, up to rounding: they are owed if they come nearer.
    Explanation nearer_by_two(Explanation light) {
        constexpr double rounding = 0.5; // levels
        if (light.found.residual.largest > rounding) {
            auto two = explain_by_two({base_of(light.found.technique)}, Strictness::everywhere);
            if (two && two->found.residual.largest < light.found.residual.largest) {
                return std::move(*two);
            }
        }
        return light;
    }

    std::optional<Explanation> explain_by_one(Strictness strictness) {
        for (const Reading &reading : all_readings(request_.observed.bytes)) {
            if (auto found = search_.explain(*plain_, singles_, reading, strictness)) {
                return Explanation{std::move(*found), reading, plain_, conventions_of(reading), strictness};
            }
        }
        return std::nullopt;
    }

    std::optional<Explanation> explain_by_two(const std::vector<Technique> &bases, Strictness strictness) {
        for (const Technique &base : bases) {
            if (auto found = search_.explain(*plain_, pairs(base), {}, strictness)) {
                return Explanation{std::move(*found), {}, plain_, {}, strictness};
            }
        }
        return std::nullopt;
    }

    /// One of bases_.
    [[nodiscard]] Technique base_of(const Technique &technique) const {
        return *std::ranges::find_if(bases_, [&](const Technique &base) {
            return base.frequency == technique.frequency && base.model == technique.model;
        });
    }

    /// The bases under which one fault comes nearest to the picture, the nearest first.
    std::vector<Technique> nearest_bases() {
        std::vector<std::pair<double, Technique>> ranked;
        for (const Technique &base : bases_) {
            double least = INFINITY;
            for (const Candidate &candidate : singles_) {
                if (base_of(candidate.technique) == base) {
                    least = std::min(least, search_.sampled_difference(*plain_, candidate.technique, {}).rms);
                }
            }
            ranked.emplace_back(least, base);
        }
        std::ranges::stable_sort(ranked, {}, &std::pair<double, Technique>::first);
        ranked.resize(std::min(ranked.size(), most_bases));
        std::vector<Technique> bases;
        std::ranges::transform(ranked, std::back_inserter(bases), &std::pair<double, Technique>::second);
        return bases;
    }

    /// Other light under techniques of so many faults, however the numbers are written.
    std::optional<Explanation> explain_by_light(const std::vector<Technique> &bases, std::size_t faults,
                                                Changes changes, const std::vector<Strictness> &strictnesses) {
        for (const Encoding encoding : {Encoding::linear, Encoding::srgb, Encoding::gamma}) {
            if (auto explanation = light_.explain({bases, faults, changes, {.encoding = encoding}, strictnesses})) {
                return explanation;
            }
        }
        return std::nullopt;
    }

    const std::vector<Candidate> &pairs(const Technique &base) {
        const auto [place, is_new] = pairs_.try_emplace(base);
        if (is_new) {
            place->second = pair_candidates(request_.scene, resources_, {base});
        }
        return place->second;
    }

    void tell(const Explanation &explanation, Diagnosis &diagnosis) {
        const Found &found = explanation.found;
        diagnosis.technique = found.technique;
        diagnosis.conventions = explanation.conventions;
        diagnosis.residual = found.residual;
        diagnosis.masked = explanation.strictness == Strictness::masked;
        std::vector<Candidate> rivals = single_candidates(explanation.pictures->scene(), resources_, bases_);
        if (found.faults == 2) {
            const auto &two = pairs(base_of(found.technique));
            rivals.insert(rivals.end(), two.begin(), two.end());
        }
        diagnosis.ties = search_.ties(*explanation.pictures, rivals, found, explanation.reading);
        const bool right = found.faults == 0 && explanation.conventions.empty();
        diagnosis.verdict = right ? Verdict::right : diagnosis.ties.empty() ? Verdict::named : Verdict::tied;
        for (const auto &trials : request_.trials) {
            if (!diagnosis.ties.empty() && !diagnosis.proposal) {
                diagnosis.proposal = propose(diagnosis.technique, diagnosis.ties, trials, draw_, [this] { report(); });
            }
        }
        if (diagnosis.proposal && request_.redraw && explanation.pictures == plain_) {
            diagnosis.after_proposal = second_look(diagnosis, explanation.reading);
        }
        show(*explanation.pictures, explanation.reading, found.compared, diagnosis);
    }

    /// Those that explain every pixel; if none does, those that explain all that `compare` compares.
    SecondLook second_look(const Diagnosis &diagnosis, const Reading &reading) {
        SecondLook look;
        std::vector<Technique> all = diagnosis.ties;
        all.insert(all.begin(), diagnosis.technique);
        try {
            const Observed observed = request_.redraw(diagnosis.proposal->scene);
            Search search(diagnosis.proposal->scene, observed, draw_, [this] { report(); });
            ScenePictures pictures(diagnosis.proposal->scene, search.sampler());
            for (const Strictness strictness : {Strictness::everywhere, Strictness::masked}) {
                if (look.remaining.empty()) {
                    std::ranges::copy_if(all, std::back_inserter(look.remaining), [&](const Technique &technique) {
                        return search.explain(pictures, {{technique, {technique}, 0}}, reading, strictness).has_value();
                    });
                }
            }
        } catch (const InputError &error) {
            look.error = error.what();
        }
        return look;
    }

    /// The first base that the scene does not refuse.
    [[nodiscard]] Technique plain_technique() const {
        const auto base =
            std::ranges::find_if(bases_, [&](const Technique &t) { return plain_->whole(t).has_value(); });
        return base == bases_.end() ? Technique{} : *base;
    }

    void tell_nearest(Diagnosis &diagnosis) {
        const auto &nearest = search_.nearest();
        if (!nearest) {
            return; // no pixel shows an object
        }
        diagnosis.technique = nearest->technique;
        diagnosis.conventions = nearest->conventions;
        const ScenePictures pictures(nearest->scene, search_.sampler());
        if (!pictures.whole(diagnosis.technique)) {
            diagnosis.technique = plain_technique(); // its samples were drawn in double; no program of the scene can
        }
        show(pictures, nearest->reading, search_.shown(), diagnosis);
        diagnosis.residual = difference_of(
            observed_levels(request_.observed, nearest->reading),
            shown_levels(pictures.whole(nearest->technique).value(), nearest->reading, request_.observed.bytes),
            search_.shown(), tolerated_levels);
    }

    /// The expected picture, and the pixel that tells most: of an explanation where it is farthest from what is right,
    /// of an unknown picture where it is farthest from the nearest.
    void show(const ScenePictures &pictures, const Reading &reading, const PixelMask &compared, Diagnosis &diagnosis) {
        const bool bytes = request_.observed.bytes;
        const Levels seen = observed_levels(request_.observed, reading);
        const Levels named = shown_levels(pictures.whole(diagnosis.technique).value(), reading, bytes);
        const Technique right = base_of(diagnosis.technique);
        const Levels truth = shown_levels(plain_->whole(right).value(), {}, bytes);
        const bool unknown = diagnosis.verdict == Verdict::unknown;
        const std::size_t i = difference_of(unknown ? seen : truth, named, compared, tolerated_levels).pixel;
        const auto width = static_cast<std::size_t>(request_.observed.numbers.size.width);
        TellingPixel &pixel = diagnosis.pixel;
        pixel.x = static_cast<int>(i % width);
        pixel.y = static_cast<int>(i / width);
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(c);
            pixel.picture[c] = static_cast<double>(seen[at]);
            pixel.named[c] = static_cast<double>(named[at]);
            pixel.right[c] = static_cast<double>(truth[at]);
        }
        const Size size = request_.observed.numbers.size;
        pixel.named_terms = term_shares(pictures.scene(), resources_, diagnosis.technique, size, pixel.x, pixel.y);
        pixel.right_terms = term_shares(request_.scene, resources_, right, size, pixel.x, pixel.y);
        diagnosis.expected = Image(size);
        for (std::size_t p = 0; p < diagnosis.expected.pixels.size(); ++p) {
            const std::size_t row = p / width;
            const std::size_t from =
                reading.flipped ? (static_cast<std::size_t>(size.height) - 1 - row) * width + p % width : p;
            for (std::size_t c = 0; c < 3; ++c) {
                diagnosis.expected.pixels[p][static_cast<int>(c)] = named[3 * from + c] / 255;
            }
        }
    }

    const DiagnosisRequest &request_;
    const DiagnosisDraw &draw_;
    const Progress &progress_;
    std::size_t steps_ = 0;
    Search search_;
    std::vector<Technique> bases_;
    std::vector<ObjectResources> resources_;
    std::shared_ptr<ScenePictures> plain_;
    std::vector<Candidate> singles_;
    LightSearch light_;
    std::map<Technique, std::vector<Candidate>> pairs_; ///< by their base
};

} // namespace

Diagnosis diagnose(const DiagnosisRequest &request, const DiagnosisDraw &draw, const Progress &progress) {
    return Diagnostician(request, draw, progress).diagnose();
}

} // namespace sandbox
