#include "shading/own_tokens.h"

#include "image/error.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace sandbox {
namespace {

constexpr int deepest_define = 16;

bool begins_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_word(char c) { return begins_word(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Longest first.
constexpr std::string_view symbols[]{"<<=", ">>=", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=",
                                     "<<",  ">>",  "<=", ">=", "==", "!=", "&&", "||", "^^", "(",  ")",  "[",
                                     "]",   "{",   "}",  ".",  ",",  ";",  "?",  ":",  "+",  "-",  "*",  "/",
                                     "%",   "<",   ">",  "=",  "!",  "~",  "&",  "|",  "^"};

class Tokeniser {
  public:
    Tokeniser(std::string_view text, const std::string &file) : text_(text), file_(file) {}

    std::vector<OwnToken> all() {
        while (auto token = next()) {
            if (token->is("#")) {
                read_directive(token->line);
            } else {
                add(*token, 0);
            }
        }
        return std::move(tokens_);
    }

  private:
    [[noreturn]] void refuse(const std::string &message) const { refuse_own(file_, line_, message); }

    [[nodiscard]] char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }
    [[nodiscard]] bool follows(std::string_view word) const { return text_.substr(at_).starts_with(word); }

    void step() {
        const bool line_ends = text_[at_] == '\n';
        line_ += line_ends ? 1 : 0;
        ++at_;
        line_start_ = line_ends ? at_ : line_start_;
    }

    /// Spaces and comments. True if there was any.
    bool skip_spaces() {
        const std::size_t start = at_;
        while (at_ < text_.size()) {
            if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
                step();
            } else if (follows("//")) {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (follows("/*")) {
                skip_block_comment();
            } else {
                break;
            }
        }
        return at_ > start;
    }

    void skip_block_comment() {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
            refuse("a comment that begins here has no end");
        }
        while (at_ < end + 2) {
            step();
        }
    }

    [[nodiscard]] std::size_t end_of_number() const {
        std::size_t end = at_;
        while (in_word(at(end)) || at(end) == '.' ||
               ((at(end) == '+' || at(end) == '-') && (at(end - 1) == 'e' || at(end - 1) == 'E') &&
                !text_.substr(at_).starts_with("0x") && !text_.substr(at_).starts_with("0X"))) {
            ++end;
        }
        return end;
    }

    std::optional<OwnToken> next() {
        const bool apart = skip_spaces();
        if (at_ >= text_.size()) {
            return std::nullopt;
        }
        OwnToken token{OwnToken::Kind::symbol, {}, line_, static_cast<int>(at_ - line_start_), apart};
        std::size_t end = at_;
        if (begins_word(at(at_))) {
            token.kind = OwnToken::Kind::word;
            while (in_word(at(end))) {
                ++end;
            }
        } else if (is_digit(at(at_)) || (at(at_) == '.' && is_digit(at(at_ + 1)))) {
            token.kind = OwnToken::Kind::number;
            end = end_of_number();
        } else if (at(at_) == '#') {
            ++end;
        } else {
            const auto *found = std::ranges::find_if(symbols, [&](std::string_view symbol) { return follows(symbol); });
            if (found == std::end(symbols)) {
                const auto byte = static_cast<unsigned char>(at(at_));
                refuse(byte > 32 && byte < 127
                           ? fmt::format("the character '{}' is not accepted outside comments", at(at_))
                           : fmt::format("the byte {:#04x} is not accepted outside comments", byte));
            }
            end += found->size();
        }
        token.text = text_.substr(at_, end - at_);
        at_ = end;
        return token;
    }

    /// After the '#'. Carried out: #define NAME VALUE, up to the line's end.
    void read_directive(int line) {
        const auto word = next_on(line);
        if (!word || !word->is("define")) {
            refuse_own(
                file_, line,
                fmt::format("#{} is not accepted: the only directive is #define NAME VALUE", word ? word->text : ""));
        }
        const auto name = next_on(line);
        if (!name || !name->is_word()) {
            refuse_own(file_, line, "expected #define NAME VALUE");
        }
        if (at(at_) == '(') {
            refuse_own(file_, line, fmt::format("#define {}(...) is not accepted: write a function", name->text));
        }
        std::vector<OwnToken> value;
        while (auto token = next_on(line)) {
            value.push_back(*std::move(token));
        }
        if (!defines_.try_emplace(name->text, std::move(value)).second) {
            refuse_own(file_, line, fmt::format("#define {}: it is defined above", name->text));
        }
    }

    /// The next token if it stands on this line.
    std::optional<OwnToken> next_on(int line) {
        const auto [place, at_line, start] = std::tuple(at_, line_, line_start_);
        auto token = next();
        if (token && (token->line != line || token->is("#"))) {
            at_ = place;
            line_ = at_line;
            line_start_ = start;
            return std::nullopt;
        }
        return token;
    }

    void add(const OwnToken &token, int depth) {
        const auto found = token.is_word() ? defines_.find(token.text) : defines_.end();
        if (tokens_.size() >= most_own_tokens || expansions_ >= most_own_tokens) {
            refuse_own(file_, token.line, fmt::format("more than {} words and symbols", most_own_tokens));
        }
        if (found == defines_.end()) {
            tokens_.push_back(token);
            return;
        }
        if (depth >= deepest_define) {
            refuse_own(
                file_, token.line,
                fmt::format("#define {} leads to itself, or through more than {} others", token.text, deepest_define));
        }
        ++expansions_;
        for (OwnToken part : found->second) {
            part.line = token.line;
            part.column = token.column;
            part.set_apart = true;
            add(part, depth + 1);
        }
    }

    std::string_view text_;
    const std::string &file_;
    std::size_t at_ = 0;
    std::size_t line_start_ = 0;
    int line_ = 1;
    std::vector<OwnToken> tokens_;
    std::map<std::string, std::vector<OwnToken>, std::less<>> defines_;
    std::size_t expansions_ = 0;
};

} // namespace

void refuse_own(const std::string &file, int line, const std::string &message) {
    throw InputError("{}:{}: {}", file, line, message);
}

std::vector<OwnToken> own_tokens(std::string_view text, const std::string &file) {
    if (text.size() > most_own_bytes) {
        throw InputError("{}: expected at most {} bytes, got {}", file, most_own_bytes, text.size());
    }
    return Tokeniser(text, file).all();
}

} // namespace sandbox
