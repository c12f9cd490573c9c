#pragma once

#include "image/error.h"

#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <utility>

namespace sandbox {

/// The lines and words of a Wavefront OBJ or MTL text: a byte order mark is skipped; lines end in LF, CR LF or CR; one
/// that ends in `\` goes on in the next; a word that begins with `#` begins a comment.
class ObjText {
  public:
    /// `name` is used in messages. Refuses UTF-16.
    ObjText(std::string_view text, std::string_view name);

    bool next_line();
    /// The next word of the line; empty at its end.
    std::string_view next_word();
    /// From 1 on; of a line that was continued, the first.
    [[nodiscard]] std::size_t line_number() const { return line_number_; }

    /// Refuses what is no number or not within `limit` of 0. One too small for a double is 0.
    [[nodiscard]] double number(std::string_view word, double limit) const;

    /// Throws InputError: "name:line: what".
    template <typename... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> what, Values &&...values) const {
        refuse_line(line_number_, fmt::format(what, std::forward<Values>(values)...));
    }
    [[noreturn]] void refuse_line(std::size_t line, std::string_view what) const {
        throw InputError("{}:{}: {}", name_, line, what);
    }

  private:
    std::string_view text_, line_;
    std::string name_;
    std::string joined_; ///< a continued line
    std::size_t at_ = 0, next_feed_ = 0;
    std::size_t line_number_ = 0, lines_taken_ = 0;

    /// One line of the file, without its end and its comment.
    std::string_view take_line();
};

} // namespace sandbox
