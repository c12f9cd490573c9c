#include "shading/rounded_text.h"

#include "shading/half.h"
#include "shading/own_tokens.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sandbox {
namespace {

using Words = std::span<const std::string_view>;
using Names = std::set<std::string, std::less<>>;

/// GLSL's own functions: those that h_NAME() takes apart, those that are one operation, and those that round nothing.
constexpr std::string_view taken_apart[]{"dot", "length", "normalize", "reflect", "cross", "pow", "smoothstep", "mod"};
constexpr std::string_view one_operation[]{"exp", "log", "sqrt", "inversesqrt", "texture"};
constexpr std::string_view exact[]{"max", "min", "abs", "floor", "clamp", "vec2", "vec3", "vec4"};
/// Parts whose functions are left alone.
constexpr std::string_view untouched[]{"math_half.glsl", "math_finite.glsl", "display_map.glsl"};
constexpr std::string_view qualifiers[]{"uniform", "in", "out", "flat"};

/// From the loosest to the tightest; from `first_rounded` on an operator makes a new number.
constexpr std::array<std::array<std::string_view, 4>, 6> operators{
    {{"||"}, {"&&"}, {"==", "!="}, {"<", ">", "<=", ">="}, {"+", "-"}, {"*", "/"}}};
constexpr std::size_t first_rounded = 4;

bool is_one_of(Words words, std::string_view text) { return std::ranges::find(words, text) != words.end(); }

class Rounding {
  public:
    explicit Rounding(const StageSource &source)
        : source_(source), body_(source.text.find('\n')), tokens_(own_tokens(without_version(), "fragment stage")),
          opened_(tokens_.size()), closed_(tokens_.size()) {
        for (const OwnToken &token : tokens_) {
            written_.push_back(token.text);
        }
    }

    std::string text() {
        while (at_ < tokens_.size()) {
            declaration();
        }
        return with_changes();
    }

  private:
    /// #version is a directive, which tokens have not.
    [[nodiscard]] std::string without_version() const { return source_.text.substr(body_); }

    [[nodiscard]] bool is(std::string_view text) const { return at_ < tokens_.size() && tokens_[at_].is(text); }
    const OwnToken &take() {
        if (at_ >= tokens_.size()) {
            throw std::logic_error("a fragment stage ends too soon");
        }
        return tokens_[at_++];
    }
    void expect(std::string_view text) {
        if (const OwnToken &token = take(); !token.is(text)) {
            throw std::logic_error("expected " + std::string(text) + ", got " + token.text);
        }
    }
    void skip_to(std::string_view text) {
        while (!take().is(text)) {
        }
    }
    /// What is in brackets, from the opening one on.
    void skip_group() {
        int depth = 0;
        do {
            const OwnToken &token = take();
            depth += token.is("(") || token.is("[") || token.is("{") ? 1 : 0;
            depth -= token.is(")") || token.is("]") || token.is("}") ? 1 : 0;
        } while (depth > 0);
    }
    void wrap(std::string_view opening, std::size_t first) {
        opened_[first].insert(0, opening);
        closed_[at_ - 1] += ")";
    }
    /// h(...) around the tokens from `first` to the last one taken.
    void round_from(std::size_t first) { wrap("h(", first); }

    void declaration() {
        if (is("struct")) {
            at_ += 3;
            while (!is("}")) {
                take(); // the type
                members_.insert(take().text);
                skip_to(";");
            }
            skip_to(";");
            return;
        }
        if (is("layout")) {
            take();
            skip_group();
        }
        while (is_one_of(qualifiers, tokens_[at_].text)) {
            take();
        }
        const OwnToken &type = take();
        const OwnToken &name = take();
        if (is("(")) {
            functions_.insert(name.text);
            skip_group();
            is_one_of(untouched, source_.origins.at(static_cast<std::size_t>(name.line) - 1).part) ? skip_group()
                                                                                                   : statement();
            return;
        }
        if (type.is("float") || type.text.starts_with("vec")) {
            globals_.insert(name.text);
        }
        skip_to(";");
    }

    void statement() {
        if (is("{")) {
            take();
            while (!is("}")) {
                statement();
            }
            take();
        } else if (is("if")) {
            take();
            condition();
            statement();
            if (is("else")) {
                take();
                statement();
            }
        } else if (is("for")) { // over integers
            take();
            skip_group();
            statement();
        } else if (is("gl_FragDepth")) {
            skip_to(";");
        } else {
            simple_statement();
            expect(";");
        }
    }

    void condition() {
        expect("(");
        expression();
        expect(")");
    }

    void simple_statement() {
        if (is("discard")) {
            take();
        } else if (is("return")) {
            take();
            expression();
        } else if (tokens_[at_].is_word() && at_ + 1 < tokens_.size() && tokens_[at_ + 1].is_word()) {
            at_ += 2; // type and name
            if (is("=")) {
                take();
                initial_value();
            }
        } else {
            assignment();
        }
    }

    /// gl_FragCoord is highp in GLSL ES, and so is what is computed from it, until it is stored.
    void initial_value() {
        const std::size_t first = at_;
        std::size_t end = at_;
        bool high = false;
        for (; !tokens_.at(end).is(";"); ++end) {
            high = high || tokens_[end].is("gl_FragCoord");
        }
        if (high) {
            at_ = end;
            round_from(first);
        } else {
            expression();
        }
    }

    /// NAME = VALUE, or NAME += VALUE, which becomes NAME = h(NAME + VALUE).
    void assignment() {
        const OwnToken &name = take();
        const std::size_t place = at_;
        const OwnToken &sign = take();
        if (sign.is("=")) {
            expression();
            return;
        }
        if (sign.text.size() != 2 || sign.text[1] != '=') {
            throw std::logic_error("expected an assignment to " + name.text + ", got " + sign.text);
        }
        const std::size_t first = at_;
        if (!expression()) {
            wrap("(", first);
        }
        written_[place] = "= h(" + name.text + " " + sign.text[0];
        closed_[at_ - 1] += ")";
    }

    /// Takes one expression. True: it may stand beside any operator without brackets.
    bool expression() {
        const bool single = binary(0);
        if (!is("?")) {
            return single;
        }
        take();
        expression();
        expect(":");
        expression();
        return false;
    }

    bool binary(std::size_t level) {
        if (level == operators.size()) {
            return unary();
        }
        const std::size_t first = at_;
        bool single = binary(level + 1);
        while (at_ < tokens_.size() && is_one_of(operators.at(level), tokens_[at_].text)) {
            take();
            binary(level + 1);
            single = level >= first_rounded;
            if (single) {
                round_from(first);
            }
        }
        return single;
    }

    bool unary() {
        if (is("-") || is("!")) {
            take();
            return unary();
        }
        const std::size_t first = at_;
        const OwnToken &token = take();
        if (token.is("(")) {
            const bool single = expression();
            expect(")");
            if (single) { // brackets that h() has made superfluous
                written_[first].clear();
                written_[at_ - 1].clear();
            }
        } else if (is("(")) {
            call(first, token.text);
        } else {
            read(first, token);
        }
        while (is(".")) {
            take();
            if (members_.contains(take().text)) { // a light's uniforms; else components
                round_from(first);
            }
        }
        return true;
    }

    void read(std::size_t first, const OwnToken &token) {
        while (is("[")) {
            skip_group();
        }
        const double number = token.is_word() ? 0 : std::strtod(token.text.c_str(), nullptr);
        if (globals_.contains(token.text) || to_half(number) != number) {
            round_from(first);
        }
    }

    void call(std::size_t first, const std::string &name) {
        take();
        while (!is(")")) {
            expression();
            if (is(",")) {
                take();
            }
        }
        take();
        if (is_one_of(taken_apart, name)) {
            written_[first] = "h_" + name;
        } else if (is_one_of(one_operation, name)) {
            round_from(first);
        } else if (!is_one_of(exact, name) && !functions_.contains(name)) {
            throw std::logic_error("there is no rounded form of " + name + "()");
        }
    }

    [[nodiscard]] std::string with_changes() const {
        const std::string rest = without_version();
        std::vector<std::size_t> lines{0};
        for (std::size_t end = rest.find('\n'); end != std::string::npos; end = rest.find('\n', end + 1)) {
            lines.push_back(end + 1);
        }
        std::string text = source_.text.substr(0, body_);
        std::size_t done = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const std::size_t place =
                lines[static_cast<std::size_t>(tokens_[i].line) - 1] + static_cast<std::size_t>(tokens_[i].column);
            text += rest.substr(done, place - done);
            text += opened_[i] + written_[i] + closed_[i];
            done = place + tokens_[i].text.size();
        }
        return text + rest.substr(done);
    }

    const StageSource &source_;
    std::size_t body_; ///< where the first line ends
    std::vector<OwnToken> tokens_;
    std::vector<std::string> written_;         ///< each token as it will be
    std::vector<std::string> opened_, closed_; ///< what is put before and after each token
    std::size_t at_ = 0;
    Names members_, globals_, functions_;
};

} // namespace

StageSource with_rounded_operations(StageSource source) {
    source.text = Rounding(source).text();
    return source;
}

} // namespace sandbox
