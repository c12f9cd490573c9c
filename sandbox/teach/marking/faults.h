#pragma once

#include "measure/diagnosis/diagnosis.h"
#include "shading/own_shader.h"
#include "shading/parts.h"
#include "teach/marking/exercise.h"
#include "teach/marking/kinds.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What is known of faults: lines that people get wrong, and what a diagnosis names. The one place that says which term
/// each of them costs.
namespace sandbox {

/// The terms that a fault may show in, the one that pays first.
struct FaultTerms {
    std::array<MarkTerm, 4> all{};
    std::size_t count = 0;
    constexpr FaultTerms(std::initializer_list<MarkTerm> terms)
        : count(terms.size()) { // NOLINT(google-explicit-constructor)
        std::size_t i = 0;
        for (const MarkTerm term : terms) {
            all[i++] = term;
        }
    }
    [[nodiscard]] std::span<const MarkTerm> terms() const { return {all.data(), count}; }
};

/// The textbook's text with one line changed.
struct WrongLine {
    std::string_view id; ///< words: mark.fault.ID
    FaultTerms terms;
    ErrorKind kind;
    std::string_view from, to; ///< `from` empty: `to` is added at the end
};
std::span<const WrongLine> wrong_lines();

/// The textbook's text of the exercise's model in which the line is wrong; nothing where that model has no such line.
std::optional<OwnShader> wrong_text(const WrongLine &line, const Exercise &exercise, const ShaderParts &parts);

/// What an answer was found to have.
struct Fault {
    MarkTerm term = MarkTerm::diffuse; ///< that pays
    ErrorKind kind = ErrorKind::shape;
    std::string key;     ///< of its sentence in assets/words; empty: a setting's
    std::string other{}; ///< of another one that cannot be told from it here; empty: none
    std::string value{}; ///< that the sentence takes: a factor
    int setting = -1;    ///< in technique_settings; -1: none
    int setting_value = 0;
};

/// Those of an explanation, each charged to a term that the exercise asks for.
std::vector<Fault> faults_of(const Technique &technique, const std::vector<Convention> &conventions,
                             const Exercise &exercise);

} // namespace sandbox
