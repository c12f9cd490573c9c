#include "teach/marking/naming.h"

#include "image/error.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/common.hpp>

namespace sandbox {
namespace {

/// Pixels that float32 decides otherwise where the line, unlike the truth, has an edge.
constexpr double line_strays = 0.01;

bool same(const glm::vec4 &a, const glm::vec4 &b, double tolerance) {
    for (int c = 0; c < 3; ++c) {
        const bool finite = std::isfinite(a[c]), other = std::isfinite(b[c]);
        const double by = static_cast<double>(std::abs(a[c] - b[c]));
        // Large light may differ in its last digits.
        if (finite != other || (finite && by > tolerance + 1e-3 * static_cast<double>(std::abs(b[c])))) {
            return false;
        }
    }
    return true;
}

bool differ(const glm::vec4 &a, const glm::vec4 &b, double tolerance) { return !same(a, b, tolerance); }

} // namespace

WrongLines::WrongLines(const Exercise &exercise, const MarkDraw &draw, Truth &truth)
    : exercise_(exercise), draw_(draw), truth_(truth) {}

PictureStore *WrongLines::pictures(const WrongLine &line) {
    const auto [place, is_new] = drawn_.try_emplace(&line);
    if (is_new) {
        if (const auto text = wrong_text(line, exercise_, *draw_.parts)) {
            const Technique technique{.frequency = exercise_.target.frequency, .model = Model::own, .own = *text};
            place->second.emplace([this, technique](const Scene &scene) {
                return draw_.trusted.picture(scene, technique, exercise_.size, false).color;
            });
        }
    }
    return place->second ? &*place->second : nullptr;
}

/// At the compared pixels; where the line changes nothing, it agrees with a right answer.
bool WrongLines::agree(const Scene &scene, PictureStore &answer, PictureStore &line) {
    const Image &own = answer.of(scene), &other = line.of(scene), &right = truth_.pictures().of(scene);
    const std::vector<std::uint8_t> &compared = truth_.compared(scene);
    constexpr double tolerance = 1.0 / 255;
    std::size_t wrong = 0, showing = 0;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        if (compared[i] != 0) {
            wrong += same(own.pixels[i], other.pixels[i], tolerance) ? 0 : 1;
            showing += differ(other.pixels[i], right.pixels[i], tolerance) ? 1 : 0;
        }
    }
    return static_cast<double>(wrong) <= line_strays * static_cast<double>(showing);
}

bool WrongLines::explains(const WrongLine &line, MarkTerm term, PictureStore &answer) {
    PictureStore *drawn = pictures(line);
    if (drawn == nullptr) {
        return false;
    }
    if (term == MarkTerm::sum) {
        return explains_all(line, answer);
    }
    const ComparedPixels compared = truth_.masks();
    const double tolerance = exercise_.find(term)->tolerance;
    bool told = false;
    for (const Unit &unit : units_of(exercise_, term)) {
        for (const Part &part : unit.parts) {
            // Normals are judged by what is right without a transform.
            const bool says = !part.needs || parts_agree({part.carrier, *part.needs, {}, true, false, {}},
                                                         {answer, truth_.pictures(), compared}, tolerance)
                                                 .value_or(false);
            const auto agree = says ? parts_agree(part, {answer, *drawn, compared}, tolerance) : std::nullopt;
            if (agree == false) {
                return false;
            }
            told = told || agree.has_value();
        }
    }
    return told;
}

bool WrongLines::explains_all(const WrongLine &line, PictureStore &answer) {
    PictureStore *drawn = pictures(line);
    return drawn != nullptr && std::ranges::all_of(exercise_.scenes, [&](const ExerciseScene &scene) {
               return scene.stiff || agree(scene.scene, answer, *drawn);
           });
}

bool WrongLines::agree_in_the_dark(const WrongLine &line, MarkTerm term, PictureStore &answer) {
    return std::ranges::all_of(units_of(exercise_, term), [&](const Unit &unit) {
        return std::ranges::all_of(unit.parts,
                                   [&](const Part &part) { return agree(part.shown.dark, answer, *pictures(line)); });
    });
}

std::vector<const WrongLine *> WrongLines::explaining(MarkTerm term, const MarkTerms &wrong, PictureStore &answer) {
    struct Merit {
        std::size_t explained = 0;
        bool in_the_dark = false;
        int terms_spared = 0;
        auto operator<=>(const Merit &) const = default;
    };
    Merit most;
    std::vector<const WrongLine *> best;
    for (const WrongLine &line : wrong_lines()) {
        const auto terms = line.terms.terms();
        if (std::ranges::count(terms, term) == 0 || !explains(line, term, answer)) {
            continue;
        }
        Merit merit;
        merit.explained = static_cast<std::size_t>(std::ranges::count_if(terms, [&](MarkTerm other) {
            return wrong.contains(other) && (other == term || explains(line, other, answer));
        }));
        merit.in_the_dark = agree_in_the_dark(line, term, answer);
        merit.terms_spared = -static_cast<int>(terms.size());
        if (best.empty() || merit > most) {
            best.clear();
            most = merit;
        }
        const bool told = std::ranges::any_of(best, [&](const WrongLine *other) { return other->id == line.id; });
        if (merit == most && !told) {
            best.push_back(&line);
        }
    }
    return best;
}

} // namespace sandbox
