#include "scene/obj_text.h"

#include "image/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <system_error>

namespace sandbox {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 18; // stays in a processor's second cache

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
constexpr bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// Characters that can be nothing but a part of a word.
constexpr std::array<bool, 256> plain_characters = [] {
    std::array<bool, 256> out{};
    for (std::size_t i = 0; i < out.size(); ++i) {
        const char c = static_cast<char>(i);
        out[i] = !is_blank(c) && !is_line_end(c) && c != '\\';
    }
    return out;
}();
constexpr bool is_plain(char c) { return plain_characters[static_cast<unsigned char>(c)]; }

/// By its mark, or, without one, by the zero beside the first character, which is ASCII in every OBJ.
bool is_utf16(std::string_view text) {
    return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
           (text.size() >= 2 && (text[0] == '\0') != (text[1] == '\0'));
}

/// Does the line go on in the next: is nothing but blanks behind this backslash?
bool goes_on(const char *backslash) {
    const char *next = backslash + 1;
    while (is_blank(*next)) {
        ++next;
    }
    return is_line_end(*next);
}

/// Behind the last line end; 0: there is none.
std::size_t whole_lines(std::string_view text) {
    if (text.ends_with('\r')) { // it may be the first half of a line end
        text.remove_suffix(1);
    }
    const std::size_t last = text.find_last_of("\r\n");
    return last == std::string_view::npos ? 0 : last + 1;
}

/// A number in the usual notation, as std::from_chars() has it: of 15 digits, both they as one whole number and the
/// power of ten are exact in a double, so that the division is all that rounds. Nothing: another notation, more digits.
std::optional<double> plain_number(std::string_view word) {
    constexpr std::array<double, 16> tens{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool negative = word.starts_with('-');
    word.remove_prefix(negative ? 1 : 0);
    if (word.size() > tens.size()) { // a point among them
        return std::nullopt;
    }
    std::uint64_t digits = 0;
    std::size_t point = word.size();
    for (std::size_t i = 0; i < word.size(); ++i) {
        const auto digit = static_cast<unsigned>(word[i] - '0');
        if (digit <= 9) {
            digits = digits * 10 + digit;
        } else if (word[i] == '.' && point == word.size()) {
            point = i;
        } else {
            return std::nullopt;
        }
    }
    const std::size_t count = word.size() - (point < word.size() ? 1 : 0);
    if (count == 0 || count >= tens.size()) {
        return std::nullopt;
    }
    const double value = static_cast<double>(digits) / (point < word.size() ? tens[count - point] : 1);
    return negative ? -value : value;
}

} // namespace

TextSource source_of(std::string_view text) {
    return [text](std::span<char> out) mutable {
        const std::size_t count = text.copy(out.data(), out.size());
        text.remove_prefix(count);
        return count;
    };
}

ObjText::ObjText(TextSource source, std::string_view name) : source_(std::move(source)), name_(name) {
    fill();
    const std::string_view text(at_, static_cast<std::size_t>(end_ - at_));
    if (is_utf16(text)) {
        throw InputError("{}: expected a text in ASCII or UTF-8, got UTF-16", name);
    }
    if (constexpr std::string_view mark = "\xef\xbb\xbf"; text.starts_with(mark)) {
        at_ += mark.size();
    }
}

void ObjText::fill() {
    auto held = static_cast<std::size_t>(end_ - at_);
    std::copy(at_, end_, block_.begin());
    std::size_t whole = 0;
    while (whole == 0 && !all_taken_) {
        if (block_.size() < held + block_size / 2) { // a long line; twice as much each time, to look at it but rarely
            block_.resize(2 * held + block_size);
        }
        const std::size_t more = source_(std::span(block_).subspan(held, block_.size() - 1 - held));
        all_taken_ = more == 0;
        held += more;
        whole = whole_lines({block_.data(), held});
    }
    block_[held] = '\n';
    at_ = block_.data();
    end_ = at_ + held;
    whole_ = all_taken_ ? end_ : at_ + whole;
}

bool ObjText::next_line() {
    if (in_line_) {
        end_line();
    }
    in_line_ = at_ != end_;
    line_number_ = lines_taken_ + 1;
    return in_line_;
}

void ObjText::end_line() {
    while (!next_word().empty()) {
    }
    take_line(); // there is but a comment
}

void ObjText::take_line() {
    while (!is_line_end(*at_)) {
        ++at_;
    }
    ++lines_taken_;
    if (at_ < end_) {
        at_ += *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n' ? 2 : 1;
    }
    if (at_ == whole_ && !all_taken_) {
        fill();
    }
}

std::string_view ObjText::next_word() {
    for (bool is_between = true; is_between;) {
        while (is_blank(*at_)) {
            ++at_;
        }
        is_between = *at_ == '\\' && goes_on(at_);
        if (is_between) {
            take_line();
        }
    }
    const char *const first = at_;
    if (*at_ != '#') {
        while (is_plain(*at_) || (*at_ == '\\' && !goes_on(at_))) {
            ++at_;
        }
    }
    return {first, static_cast<std::size_t>(at_ - first)};
}

std::string ObjText::rest() {
    std::string out;
    const char *behind = nullptr;
    std::size_t line = 0;
    for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
        if (!out.empty() && line == lines_taken_) {
            out.append(behind, word.data());
        } else if (!out.empty()) {
            out += ' ';
        }
        out += word;
        behind = at_;
        line = lines_taken_;
    }
    return out;
}

std::optional<double> ObjText::finite_number(std::string_view word) {
    if (const auto value = plain_number(word)) {
        return value;
    }
    word.remove_prefix(word.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [end, error] = read_number(word.data(), word.data() + word.size(), value);
    const bool whole = !word.empty() && error == std::errc() && end == word.data() + word.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double ObjText::number(std::string_view word, double limit) const {
    const auto value = plain_number(word);
    return value && std::abs(*value) <= limit ? *value : any_number(word, limit);
}

double ObjText::any_number(std::string_view word, double limit) const {
    double value = 0;
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    const auto [end, error] = read_number(digits.data(), digits.data() + digits.size(), value);
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
