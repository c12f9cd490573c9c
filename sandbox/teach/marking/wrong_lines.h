#pragma once

#include "shading/own_shader.h"
#include "shading/parts.h"
#include "teach/marking/exercise.h"
#include "teach/marking/kinds.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

/// Lines that people get wrong, as changes of the textbook's text: drawn, they show what an answer's pictures are. What
/// people add is a row and its sentence in assets/words.
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

} // namespace sandbox
