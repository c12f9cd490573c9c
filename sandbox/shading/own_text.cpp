#include "shading/own_text.h"

#include "image/error.h"
#include "shading/own_calls.h"
#include "shading/own_interface.h"
#include "shading/own_structure.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sandbox {
namespace {

/// Stages have their own storage, outputs and ways to end; own shading has an interface instead.
constexpr std::string_view refused_words[]{
    "uniform",   "attribute", "varying",  "layout",   "centroid",   "flat",  "smooth", "noperspective",
    "buffer",    "shared",    "coherent", "volatile", "restrict",   "patch", "sample", "readonly",
    "writeonly", "invariant", "precise",  "discard",  "subroutine", "asm",   "goto",   "main",
    "sampler2D", "image2D",   "union",    "template", "samplerCube"};

void refuse_words(const OwnStructure &s) {
    for (const OwnToken &token : s.tokens) {
        if (!token.is_word()) {
            continue;
        }
        if (std::ranges::find(refused_words, token.text) != std::end(refused_words) || token.text.starts_with("gl_")) {
            s.refuse(token, fmt::format("'{}' is not accepted: own shading reads its interface and returns light",
                                        token.text));
        }
        if (token.text.starts_with("own_") || token.text.find("__") != std::string::npos) {
            s.refuse(token, fmt::format("the name '{}' is kept for the program", token.text));
        }
    }
}

/// Parsers call themselves for every operator of a statement and every `else`.
void refuse_long_statements(const OwnStructure &s) {
    std::size_t length = 0;
    int elses = 0;
    for (const OwnToken &token : s.tokens) {
        const bool ends = token.is(";") || token.is("{") || token.is("}");
        length = ends ? 0 : length + 1;
        elses += token.is("else") ? 1 : 0;
        if (length > longest_statement) {
            s.refuse(token, fmt::format("a statement of more than {} words and symbols", longest_statement));
        }
        if (elses > most_own_elses) {
            s.refuse(token, fmt::format("more than {} times else", most_own_elses));
        }
    }
}

/// What is put before each token so that no loop takes more than its turns.
class LoopBudget {
  public:
    explicit LoopBudget(const OwnStructure &s) : s_(s), before_(s.tokens.size() + 1) {
        for (std::size_t i = 0; i < s.tokens.size(); ++i) {
            if (s.tokens[i].is("for") || s.tokens[i].is("while")) {
                limit(i);
            }
        }
    }
    [[nodiscard]] const std::string &before(std::size_t token) const { return before_[token]; }
    [[nodiscard]] bool any() const { return any_; }

  private:
    void limit(std::size_t loop) {
        const bool is_for = s_.tokens[loop].is("for");
        if (loop + 1 == s_.tokens.size() || !s_.tokens[loop + 1].is("(")) {
            s_.refuse(s_.tokens[loop], fmt::format("expected '(' after {}", s_.tokens[loop].text));
        }
        std::size_t begin = loop + 2;
        std::size_t end = s_.partner[loop + 1];
        if (is_for) {
            std::vector<std::size_t> ends;
            for (std::size_t i = begin; i < end; i = s_.after(i)) {
                if (s_.tokens[i].is(";")) {
                    ends.push_back(i);
                }
            }
            if (ends.size() != 2) {
                s_.refuse(s_.tokens[loop], "expected for (START; CONDITION; STEP)");
            }
            begin = ends[0] + 1;
            end = ends[1];
        }
        if (begin + 1 < end && s_.tokens[begin].is_word() && s_.tokens[begin + 1].is_word()) {
            s_.refuse(s_.tokens[begin], "a declaration as the condition of a loop is not accepted");
        }
        before_[begin] += begin == end ? "own_turn()" : "own_turn() && (";
        before_[end] += begin == end ? "" : ")";
        any_ = true;
    }

    const OwnStructure &s_;
    std::vector<std::string> before_;
    bool any_ = false;
};

/// The tokens where they stood, line by line.
std::vector<std::string> lines_of(const OwnStructure &s, const LoopBudget &budget, std::size_t count) {
    std::vector<std::string> lines(count);
    for (std::size_t i = 0; i < s.tokens.size(); ++i) {
        const OwnToken &token = s.tokens[i];
        std::string &line = lines[static_cast<std::size_t>(token.line) - 1];
        if (line.empty()) {
            line.assign(static_cast<std::size_t>(std::min(token.column, 120)), ' ');
        } else if (token.set_apart) {
            line += ' ';
        }
        line += budget.before(i) + token.text;
    }
    return lines;
}

bool calls(const OwnStructure &s, std::string_view name) {
    for (std::size_t i = 0; i + 1 < s.tokens.size(); ++i) {
        if (s.tokens[i].is(name) && s.tokens[i + 1].is("(")) {
            return true;
        }
    }
    return false;
}

/// Does the function's body name its parameter?
bool reads(const OwnStructure &s, const OwnFunction &function, std::size_t parameter) {
    const std::string &name = function.parameters[parameter].name;
    return !name.empty() && std::any_of(s.tokens.begin() + static_cast<std::ptrdiff_t>(function.body),
                                        s.tokens.begin() + static_cast<std::ptrdiff_t>(s.partner[function.body]),
                                        [&](const OwnToken &token) { return token.is(name); });
}

/// The function of this name, which takes `parameters` vec3 and returns one; none if there is none of the name.
const OwnFunction *entry(const OwnStructure &s, std::string_view name, std::size_t parameters,
                         std::string_view signature) {
    const auto found = std::ranges::find(s.functions, name, &OwnFunction::name);
    if (found == s.functions.end()) {
        return nullptr;
    }
    const bool fits =
        found->type == "vec3" && found->parameters.size() == parameters &&
        std::ranges::all_of(found->parameters, [](const OwnParameter &p) { return p.type == "vec3" && !p.writes; });
    if (!fits) {
        refuse_own(s.file, found->line, fmt::format("expected {}", signature));
    }
    return &*found;
}

} // namespace

OwnText read_own_text(std::string file, std::string text) {
    OwnText own;
    own.file = std::move(file);
    own.text = std::move(text);
    const OwnStructure s = own_structure(own_tokens(own.text, own.file), own.file);
    refuse_words(s);
    refuse_long_statements(s);
    refuse_large_arrays(s);
    refuse_endless_calls(s);
    const LoopBudget budget(s);
    const OwnFunction *lighting = entry(s, "lighting", 3, own_entries[0].signature);
    if (lighting == nullptr) {
        throw InputError("{}: expected a function {}", own.file, own_entries[0].signature);
    }
    own.reads_P = reads(s, *lighting, 0);
    own.reads_N = reads(s, *lighting, 1);
    own.reads_eye = reads(s, *lighting, 2);
    own.position = entry(s, "position", 1, own_entries[1].signature) != nullptr;
    own.normal = entry(s, "normal", 1, own_entries[2].signature) != nullptr;
    own.base = calls(s, "base");
    own.makes_lights = calls(s, "Light");
    own.loops = budget.any();
    for (const OwnToken &token : s.tokens) {
        if (token.is_word()) {
            own.words.insert(token.text);
        }
    }
    own.lines = lines_of(s, budget, static_cast<std::size_t>(std::ranges::count(own.text, '\n')) + 1);
    return own;
}

} // namespace sandbox
