#include "teach/marking/sentences.h"

#include "image/plain_text.h"
#include "words/row_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sandbox {
namespace {

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.3g}", value) : "NaN"; }
std::string color(const glm::dvec3 &v) { return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z)); }

std::string scene_words(const Words &words, const ExerciseScene &scene) {
    return scene.withheld ? words.text("mark.scene_withheld")
                          : words.format("mark.scene", file_text(words, scene.name));
}

/// A compiler's messages may be long, and have a line each.
std::string on_one_line(std::string text) {
    constexpr std::size_t longest = 300;
    text.resize(std::min(text.size(), text.find_last_not_of('\n') + 1));
    if (text.size() > longest) {
        text = text.substr(0, longest) + "...";
    }
    std::ranges::replace(text, '\n', ' ');
    return plain_text(text);
}

class Sentences {
  public:
    Sentences(const Words &words, const Exercise &exercise, const Mark &mark, int hints)
        : words_(words), exercise_(exercise), mark_(mark), hints_(hints) {}

    [[nodiscard]] std::string of(const TermResult &result) const {
        const std::string title = title_of(words_, result.term);
        if (result.spared) {
            return words_.format("mark.spared", title);
        }
        if (result.units == 0 || !result.worst) {
            return unjudged(title, result.term);
        }
        const WorstPixel &worst = *result.worst;
        std::string text = where(title, worst) + words_.text("mark.stop");
        const Fault *fault = fault_of(result.term);
        const bool told = worst.kind == ErrorKind::not_finite || worst.kind == ErrorKind::unheeding;
        if (hints_ >= 2 && !told) {
            const bool missing = worst.kind == ErrorKind::missing && !worst.factor;
            text += kind(result.term, fault != nullptr && !missing ? fault->kind : worst.kind) + " ";
        }
        if (hints_ >= 3 && fault != nullptr) {
            text += fault_text(*fault);
        }
        text.resize(text.find_last_not_of(' ') + 1);
        return spaced(words_, text);
    }

  private:
    const Words &words_;
    const Exercise &exercise_;
    const Mark &mark_;
    int hints_;

    [[nodiscard]] const Fault *fault_of(MarkTerm term) const {
        const auto found = std::ranges::find(mark_.faults, term, &Fault::term);
        return found == mark_.faults.end() ? nullptr : &*found;
    }
    [[nodiscard]] std::string unjudged(const std::string &title, MarkTerm term) const {
        std::string first;
        for (const TermResult &other : mark_.judgement.terms) {
            const bool shows_it = other.term == MarkTerm::diffuse || other.term == MarkTerm::specular;
            if (shows_it && other.term != term && !other.is_right()) {
                first += (first.empty() ? "" : words_.text("mark.and")) + title_of(words_, other.term);
            }
        }
        return first.empty() ? words_.format("mark.unjudged", title)
                             : words_.format("mark.unjudged.first_mend", title, first);
    }
    [[nodiscard]] std::string where(const std::string &title, const WorstPixel &worst) const {
        const std::string scene = scene_words(words_, exercise_.scenes[worst.scene]);
        if (worst.kind == ErrorKind::not_finite) {
            return words_.format("mark.where_not_finite", title, scene, worst.x, worst.y);
        }
        if (worst.kind == ErrorKind::unheeding) {
            return words_.format("mark.where_unheeding", title, scene, worst.x, worst.y);
        }
        const bool factor = worst.factor;
        const Size size = mark_.of_picture ? mark_.student.size : exercise_.size;
        return words_.format(factor ? "mark.where_factor" : "mark.where", title, scene, worst.x, worst.y,
                             factor ? number(worst.answer.x) : color(worst.answer),
                             factor ? number(worst.truth.x) : color(worst.truth), size.width, size.height);
    }
    [[nodiscard]] std::string kind(MarkTerm term, ErrorKind kind) const {
        std::string word(kind_words[static_cast<std::size_t>(kind)]);
        if (term == MarkTerm::sum && kind != ErrorKind::not_finite) {
            const bool strength = kind == ErrorKind::too_bright || kind == ErrorKind::too_dark;
            return words_.text("mark.kind.sum." + (strength ? word : "shape"));
        }
        const bool multiplies = term == MarkTerm::attenuation || term == MarkTerm::cone;
        const bool by_a_factor =
            kind == ErrorKind::too_bright || kind == ErrorKind::too_dark || kind == ErrorKind::missing;
        return words_.text((multiplies && by_a_factor ? "mark.kind.factor." : "mark.kind.") + word);
    }
    [[nodiscard]] std::string fault_text(const Fault &fault) const {
        if (fault.setting < 0) {
            const std::string text = words_.format(fault.key, plain_text(fault.value));
            return fault.other.empty() ? text : words_.format("mark.either", text, words_.text(fault.other));
        }
        const TechniqueKey &key = technique_settings[fault.setting];
        return words_.format("mark.setting", title_of(words_, key), look_for(words_, key, fault.setting_value));
    }
};

} // namespace

std::string title_of(const Words &words, MarkTerm term) {
    return words.text(fmt::format("mark.term.{}", term_words[static_cast<std::size_t>(term)]));
}

std::string sentence(const Words &words, const Exercise &exercise, const Mark &mark, const TermResult &result,
                     int hints) {
    return hints == 0 ? "" : Sentences(words, exercise, mark, hints).of(result);
}

std::vector<std::string> sentences(const Words &words, const Exercise &exercise, const Mark &mark, int hints) {
    if (!mark.refused.empty()) {
        return {words.format("mark.refused", on_one_line(mark.refused))};
    }
    if (mark.unknown) {
        return {words.text("mark.unknown")};
    }
    std::vector<std::string> all;
    const Sentences said(words, exercise, mark, hints);
    for (const TermResult &result : mark.judgement.terms) {
        if (hints > 0 && !result.is_right()) {
            all.push_back(said.of(result));
        }
    }
    if (hints > 0 && all.empty()) {
        all.push_back(words.text("mark.all_right"));
    }
    return all;
}

} // namespace sandbox
