#include "scene/obj_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace sandbox {
namespace {

constexpr std::string_view blanks = " \t\v\f";

/// By its mark, or, without one, by the zero beside the first character, which is ASCII in every OBJ.
bool is_utf16(std::string_view text) {
    return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
           (text.size() >= 2 && (text[0] == '\0') != (text[1] == '\0'));
}

/// Where a line goes on in the next: at its last character but blanks; npos: it does not.
std::size_t continuation(std::string_view line) {
    const std::size_t last = line.find_last_not_of(blanks);
    return last != std::string_view::npos && line[last] == '\\' ? last : std::string_view::npos;
}

/// Where a comment begins: a # within a word (a name, 1.#QNAN) begins none. npos: nowhere.
std::size_t comment(std::string_view line) {
    std::size_t at = line.find('#');
    while (at != std::string_view::npos && at > 0 && blanks.find(line[at - 1]) == std::string_view::npos) {
        at = line.find('#', at + 1);
    }
    return at;
}

} // namespace

ObjText::ObjText(std::string_view text, std::string_view name) : text_(text), name_(name) {
    if (is_utf16(text)) {
        throw InputError("{}: expected a text in ASCII or UTF-8, got UTF-16", name);
    }
    if (constexpr std::string_view mark = "\xef\xbb\xbf"; text.starts_with(mark)) {
        at_ = mark.size();
    }
    next_feed_ = text_.find('\n', at_);
}

std::string_view ObjText::take_line() {
    ++lines_taken_;
    if (next_feed_ != std::string_view::npos && next_feed_ < at_) {
        next_feed_ = text_.find('\n', at_);
    }
    // Looked for up to the next LF only, which is kept: a text of CRs alone is gone through once.
    const std::size_t whole = std::min(next_feed_, text_.size());
    std::string_view line = text_.substr(at_, whole - at_);
    line = line.substr(0, line.find('\r'));
    at_ += line.size();
    at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    return line.substr(0, comment(line));
}

bool ObjText::next_line() {
    if (at_ >= text_.size()) {
        return false;
    }
    line_number_ = lines_taken_ + 1;
    line_ = take_line();
    std::size_t end = continuation(line_);
    if (end == std::string_view::npos) {
        return true;
    }
    joined_.clear();
    std::string_view part = line_;
    for (; end != std::string_view::npos && at_ < text_.size(); end = continuation(part)) {
        joined_.append(part.substr(0, end)).push_back(' ');
        part = take_line();
    }
    joined_.append(part.substr(0, end));
    line_ = joined_;
    return true;
}

std::string_view ObjText::next_word() {
    line_.remove_prefix(std::min(line_.find_first_not_of(blanks), line_.size()));
    const std::string_view word = line_.substr(0, line_.find_first_of(blanks));
    line_.remove_prefix(word.size());
    return word;
}

double ObjText::number(std::string_view word, double limit) const {
    double value = 0;
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = !digits.empty() && !word.starts_with("+-") && end == digits.data() + digits.size();
    const bool out_of_double = error == std::errc::result_out_of_range;
    if (whole && out_of_double) {
        const std::size_t exponent = std::min(digits.find_first_of("eE"), digits.size());
        if (digits.substr(exponent).find('-') != std::string_view::npos) {
            return 0;
        }
    }
    if (whole && (out_of_double || (std::isfinite(value) && std::abs(value) > limit))) {
        refuse("expected a number within {:g} of 0, got \"{:.40}\"", limit, word);
    }
    if (!whole || error != std::errc() || !std::isfinite(value)) {
        refuse("expected a number, got \"{:.40}\"", word);
    }
    return value;
}

} // namespace sandbox
