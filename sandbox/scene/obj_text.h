#pragma once

#include "image/error.h"

#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sandbox {

/// Puts the next bytes of a text where it is told; returns how many, 0 at the end.
using TextSource = std::function<std::size_t(std::span<char>)>;
/// `text` must outlive it.
TextSource source_of(std::string_view text);

/// The lines and words of a Wavefront OBJ or MTL text: a byte order mark is skipped; lines end in LF, CR LF or CR; one
/// that ends in `\` goes on in the next; a word that begins with `#` begins a comment. Holds a block of the text only.
class ObjText {
  public:
    /// `name` is used in messages. Refuses UTF-16.
    ObjText(TextSource source, std::string_view name);

    bool next_line();
    /// The next word of the line; empty at its end. Good until the next call.
    std::string_view next_word();
    /// All that is left of the line, without blanks around it; words keep theirs between them.
    std::string rest();
    /// From 1 on; of a line that was continued, the first.
    [[nodiscard]] std::size_t line_number() const { return line_number_; }

    /// Nothing: no number, or not a finite one.
    static std::optional<double> finite_number(std::string_view word);
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
    TextSource source_;
    std::string name_;
    std::vector<char> block_;     ///< a line end stands behind its last byte
    const char *at_ = nullptr;    ///< in the block, as are the next two
    const char *whole_ = nullptr; ///< behind the last line that is there with its end
    const char *end_ = nullptr;
    bool all_taken_ = false; ///< the source has no more
    bool in_line_ = false;
    std::size_t line_number_ = 0, lines_taken_ = 0;

    /// Moves what is left of the block to its start and takes more behind it, till a whole line is there.
    void fill();
    /// Passes over what nobody read of the line, with those that it goes on in.
    void end_line();
    /// Passes over the rest of one line of the file.
    void take_line();
    [[nodiscard]] double any_number(std::string_view word, double limit) const;
};

} // namespace sandbox
