#include "teach/marking/marker.h"

#include "image/error.h"
#include "reference/reference.h"
#include "shading/own_text.h"
#include "teach/marking/naming.h"
#include "teach/marking/truth.h"

#include <algorithm>
#include <glm/common.hpp>

namespace sandbox {
namespace {

Technique own_technique(const Exercise &exercise, const OwnShader &text) {
    return {.frequency = exercise.target.frequency, .model = Model::own, .own = text};
}

/// The light that a picture stands for, if its numbers were encoded so.
Image decoded_image(Image image, Encoding encoding) {
    for (glm::vec4 &pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) {
            pixel[c] = static_cast<float>(decoded(static_cast<double>(pixel[c]), encoding));
        }
    }
    return image;
}

/// Where two pictures differ most.
WorstPixel worst_pixel(const Image &student, const Image &truth) {
    std::size_t worst = 0;
    float most = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const glm::vec4 by = glm::abs(student.pixels[i] - truth.pixels[i]);
        if (const float here = std::max({by.x, by.y, by.z}); here > most) {
            most = here;
            worst = i;
        }
    }
    const auto width = static_cast<std::size_t>(truth.size.width);
    return {0, static_cast<int>(worst % width), static_cast<int>(worst / width), glm::vec3(student.pixels[worst]),
            glm::vec3(truth.pixels[worst])};
}

bool all_right(const Judgement &judgement) { return std::ranges::all_of(judgement.terms, &TermResult::is_right); }

} // namespace

struct Marker::Impl {
    Impl(const Exercise &asked, const MarkDraw &how)
        : exercise(asked), draw(how), truth(asked, how), lines(asked, how, truth) {}

    const Exercise &exercise;
    const MarkDraw &draw;
    Truth truth;
    WrongLines lines;
    std::optional<Image> shown_truth;

    [[nodiscard]] Size shown_size() const { return {2 * exercise.size.width, 2 * exercise.size.height}; }
    const Image &truth_shown() {
        if (!shown_truth) {
            const Scene &scene = exercise.shown_scene();
            shown_truth =
                to_frame(render_reference(scene, draw.trusted.load(scene), exercise.target, shown_size())).color;
        }
        return *shown_truth;
    }
    [[nodiscard]] Sides sides(PictureStore &answer) {
        return {answer, truth.pictures(), truth.masks(), exercise.find(MarkTerm::robustness) != nullptr};
    }

    void refuse_other_words(const OwnText &text) const {
        for (const std::string &word : exercise.has) {
            if (!text.names(word)) {
                throw InputError("{}: the exercise asks for '{}', which is not in it", text.file, word);
            }
        }
        for (const std::string &word : exercise.lacks) {
            if (text.names(word)) {
                throw InputError("{}: the exercise asks to do without '{}'", text.file, word);
            }
        }
    }

    Mark mark_own(const OwnShader &text) {
        refuse_other_words(*text);
        const Technique technique = own_technique(exercise, text);
        const auto drawn = [&](const Scene &scene, Size size) { return draw.own(scene, technique, size, false).color; };
        PictureStore answer([&](const Scene &scene) { return drawn(scene, exercise.size); });
        Mark mark;
        mark.student = drawn(exercise.shown_scene(), shown_size());
        mark.truth = truth_shown();
        mark.judgement = judge(exercise, sides(answer));
        if (!all_right(mark.judgement)) {
            if (!name_encoding(mark, answer)) {
                name_lines(mark, answer);
                name_by_diagnosis(mark, answer);
            }
        }
        return mark;
    }

    /// Is the result encoded for a screen? Then the terms are judged as light, and only their sum pays.
    bool name_encoding(Mark &mark, PictureStore &answer) {
        for (const Encoding encoding : {Encoding::gamma, Encoding::srgb}) {
            PictureStore light([&](const Scene &scene) { return decoded_image(answer.of(scene), encoding); });
            Judgement judgement = judge(exercise, sides(light));
            const bool all_terms = std::ranges::all_of(judgement.terms, [](const TermResult &result) {
                return result.is_right() || result.term == MarkTerm::sum || result.term == MarkTerm::robustness;
            });
            if (!all_terms) {
                continue;
            }
            TermResult *payer = judgement.find(MarkTerm::sum);
            payer = payer != nullptr ? payer : &judgement.terms.front();
            const TermResult *before = mark.judgement.find(payer->term);
            payer->right = 0;
            payer->worst = before->worst;
            mark.judgement = std::move(judgement);
            const bool srgb = encoding == Encoding::srgb;
            mark.faults = {{payer->term, ErrorKind::too_bright,
                            srgb ? "mark.convention.display.srgb" : "mark.convention.display.gamma-2.2"}};
            return true;
        }
        return false;
    }

    /// What is wrong, is shown, and may be a line's fault.
    [[nodiscard]] static MarkTerms open_terms(const Judgement &judgement) {
        MarkTerms open;
        for (const TermResult &result : judgement.terms) {
            if (!result.is_right() && result.units > 0 && !result.spared && result.term != MarkTerm::robustness) {
                open.insert(result.term);
            }
        }
        return open;
    }

    /// A line that explains several terms costs only the first of them, in the line's own order.
    void name_lines(Mark &mark, PictureStore &answer) {
        const MarkTerms wrong = open_terms(mark.judgement);
        for (const MarkTerm term : wrong) {
            if (mark.judgement.find(term)->spared || is_named(mark, term)) {
                continue;
            }
            const auto found = lines.explaining(term, wrong, answer);
            if (!found.empty()) {
                charge(mark, found, wrong, answer);
            }
        }
    }
    void charge(Mark &mark, const std::vector<const WrongLine *> &found, const MarkTerms &wrong, PictureStore &answer) {
        const WrongLine &line = *found.front();
        const std::string other = found.size() > 1 ? "mark.fault." + std::string(found[1]->id) : std::string();
        bool paid = false;
        for (const MarkTerm shown : line.terms.terms()) {
            if (!wrong.contains(shown) || !lines.explains(line, shown, answer)) {
                continue;
            }
            if (paid) {
                mark.judgement.find(shown)->spared = true;
            } else {
                mark.faults.push_back({shown, line.kind, "mark.fault." + std::string(line.id), other});
            }
            paid = true;
        }
        if (lines.explains_all(line, answer)) { // the answer has this fault and no other, so nothing else may cost
            for (TermResult &result : mark.judgement.terms) {
                result.spared = result.spared || (!result.is_right() && !is_named(mark, result.term) &&
                                                  result.term != MarkTerm::robustness);
            }
        }
    }

    [[nodiscard]] bool is_named(const Mark &mark, MarkTerm term) const {
        return std::ranges::any_of(mark.faults, [&](const Fault &fault) { return fault.term == term; });
    }

    /// What no line explains may be a fault of techniques, or another convention.
    void name_by_diagnosis(Mark &mark, PictureStore &answer) {
        const bool open =
            std::ranges::any_of(open_terms(mark.judgement), [&](MarkTerm term) { return !is_named(mark, term); });
        if (!open) {
            return;
        }
        const Scene &scene = exercise.shown_scene();
        const Diagnosis found = diagnose({scene, {answer.of(scene), false}, exercise.target, {}, {}}, draw.trusted);
        if (found.verdict != Verdict::named && found.verdict != Verdict::tied) {
            return;
        }
        for (Fault &fault : faults_of(found.technique, found.conventions, exercise)) {
            const TermResult *result = mark.judgement.find(fault.term);
            if (result != nullptr && !result->is_right() && !is_named(mark, fault.term)) {
                mark.faults.push_back(std::move(fault));
            }
        }
    }

    /// Of the explanations that tie, the one that costs least.
    [[nodiscard]] std::vector<Fault> cheapest(const Diagnosis &found) const {
        std::vector<Fault> best = faults_of(found.technique, found.conventions, exercise);
        for (const Technique &tie : found.ties) {
            std::vector<Fault> other = faults_of(tie, found.conventions, exercise);
            if (cost(other) < cost(best)) {
                best = std::move(other);
            }
        }
        return best;
    }
    [[nodiscard]] double cost(const std::vector<Fault> &faults) const {
        double sum = 0;
        for (const TermPoints &row : exercise.terms) {
            const bool pays = std::ranges::any_of(faults, [&](const Fault &fault) { return fault.term == row.term; });
            sum += pays ? row.points : 0;
        }
        return sum;
    }

    Mark mark_picture(const Observed &picture) {
        const Size size = picture.numbers.size;
        if (size.width * size.height > most_handed_in_pixels) {
            throw InputError("expected a picture of at most {} pixels, got {} x {}", most_handed_in_pixels, size.width,
                             size.height);
        }
        Mark mark;
        mark.of_picture = true;
        const Scene &scene = exercise.shown_scene();
        mark.student = picture.numbers;
        mark.truth = to_frame(render_reference(scene, draw.trusted.load(scene), exercise.target, size)).color;
        Diagnosis found = diagnose({scene, picture, exercise.target, {}, {}}, draw.trusted);
        if (found.verdict == Verdict::unknown) {
            Diagnosis other = diagnose({scene, picture, {}, {}, {}}, draw.trusted);
            found = other.verdict == Verdict::unknown ? std::move(found) : std::move(other);
        }
        mark.unknown = found.verdict == Verdict::unknown;
        if (mark.unknown) {
            return mark;
        }
        mark.faults = found.verdict == Verdict::right && found.technique == exercise.target ? std::vector<Fault>{}
                                                                                            : cheapest(found);
        for (const TermPoints &row : exercise.terms) {
            const bool pays =
                std::ranges::any_of(mark.faults, [&](const Fault &fault) { return fault.term == row.term; });
            TermResult result{row.term, 1, pays ? 0U : 1U, {}, false};
            if (pays) {
                result.worst = worst_pixel(mark.student, mark.truth);
            }
            mark.judgement.terms.push_back(result);
        }
        return mark;
    }
};

Marker::Marker(const Exercise &exercise, const MarkDraw &draw) : impl_(std::make_unique<Impl>(exercise, draw)) {}
Marker::~Marker() = default;

Mark Marker::refuse(std::string why) const {
    Mark mark;
    for (const TermPoints &row : impl_->exercise.terms) {
        mark.judgement.terms.push_back({row.term, 0, 0, {}, false});
    }
    mark.refused = std::move(why);
    return mark;
}

Mark Marker::mark_own(const OwnShader &text) {
    try {
        return impl_->mark_own(text);
    } catch (const InputError &error) {
        return refuse(error.what());
    }
}

Mark Marker::mark_picture(const Observed &picture) {
    try {
        return impl_->mark_picture(picture);
    } catch (const InputError &error) {
        return refuse(error.what());
    }
}

} // namespace sandbox
