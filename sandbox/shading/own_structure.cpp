#include "shading/own_structure.h"

#include "shading/own_text.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <utility>

namespace sandbox {
namespace {

constexpr std::string_view open_brackets = "([{";
constexpr std::string_view close_brackets = ")]}";
constexpr std::string_view qualifiers[]{"const", "in", "out", "inout", "highp", "mediump", "lowp"};
constexpr int most_fields = 64;
constexpr int most_lights = 64;

bool is_qualifier(const OwnToken &token) { return std::ranges::find(qualifiers, token.text) != std::end(qualifiers); }

void pair_brackets(OwnStructure &s) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < s.tokens.size(); ++i) {
        s.partner.push_back(i);
        const std::string &text = s.tokens[i].text;
        if (text.size() != 1) {
            continue;
        }
        if (open_brackets.find(text) != std::string_view::npos) {
            open.push_back(i);
            if (open.size() > deepest_own_nesting) {
                s.refuse(s.tokens[i], fmt::format("brackets more than {} deep", deepest_own_nesting));
            }
        } else if (const auto kind = close_brackets.find(text); kind != std::string_view::npos) {
            if (open.empty() || s.tokens[open.back()].text[0] != open_brackets[kind]) {
                s.refuse(s.tokens[i], fmt::format("this '{}' closes nothing", text));
            }
            s.partner[i] = open.back();
            s.partner[open.back()] = i;
            open.pop_back();
        }
    }
    if (!open.empty()) {
        s.refuse(s.tokens[open.back()], fmt::format("this '{}' is not closed", s.tokens[open.back()].text));
    }
}

void find_structs(OwnStructure &s) {
    for (std::size_t i = 0; i + 2 < s.tokens.size(); ++i) {
        if (!s.tokens[i].is("struct")) {
            continue;
        }
        const std::size_t open = i + 2;
        if (!s.tokens[i + 1].is_word() || !s.tokens[open].is("{")) {
            s.refuse(s.tokens[i], "expected struct NAME { ... }");
        }
        OwnStruct found{s.tokens[i + 1].text, 0};
        for (std::size_t j = open + 1; j < s.partner[open]; ++j) {
            const OwnToken &token = s.tokens[j];
            const bool is_struct = std::ranges::find(s.structs, token.text, &OwnStruct::name) != s.structs.end();
            if (token.is("[") || token.is("struct") || token.is("Light") || token.is("Material") || is_struct) {
                s.refuse(token, "an array or a struct inside a struct is not accepted");
            }
            found.fields += token.is(";") || token.is(",") ? 1 : 0;
        }
        if (found.fields > most_fields) {
            s.refuse(s.tokens[i], fmt::format("a struct of more than {} fields", most_fields));
        }
        s.structs.push_back(std::move(found));
    }
}

OwnParameter parameter_of(const OwnStructure &s, std::size_t from, std::size_t to) {
    OwnParameter parameter;
    for (; from < to && is_qualifier(s.tokens[from]); ++from) {
        parameter.writes |= s.tokens[from].is("out") || s.tokens[from].is("inout");
    }
    parameter.type = from < to ? s.tokens[from].text : "";
    parameter.name = from + 1 < to ? s.tokens[from + 1].text : "";
    return parameter;
}

/// The function whose body opens at `body`.
void add_function(OwnStructure &s, std::size_t start, std::size_t body) {
    const std::size_t close = body - 1;
    const std::size_t open = s.partner[close];
    if (open < start + 2 || !s.tokens[open - 1].is_word() || !s.tokens[open - 2].is_word()) {
        s.refuse(s.tokens[body], "expected a function: TYPE NAME(PARAMETERS) { ... }");
    }
    OwnFunction function{s.tokens[open - 2].text, s.tokens[open - 1].text, {}, body, s.tokens[open - 1].line};
    std::size_t from = open + 1;
    for (std::size_t i = from; i <= close; i = i == close ? i + 1 : s.after(i)) {
        if ((i == close || s.tokens[i].is(",")) && i > from) {
            function.parameters.push_back(parameter_of(s, from, i));
        }
        from = s.tokens[i].is(",") ? i + 1 : from;
    }
    if (function.parameters.size() == 1 && function.parameters[0].type == "void") {
        function.parameters.clear();
    }
    s.functions.push_back(std::move(function));
}

void find_functions(OwnStructure &s) {
    std::size_t start = 0;
    for (std::size_t i = 0; i < s.tokens.size(); i = s.after(i)) {
        if (s.tokens[i].is("{") && i > start && s.tokens[i - 1].is(")")) {
            add_function(s, start, i);
            start = s.partner[i] + 1;
        } else if (s.tokens[i].is(";")) {
            start = i + 1;
        }
    }
}

/// Where declarators may follow after a comma: the statement declares variables.
bool declares(const OwnStructure &s, std::size_t from) {
    while (from < s.tokens.size() && is_qualifier(s.tokens[from])) {
        ++from;
    }
    return from + 1 < s.tokens.size() && s.is_type(s.tokens[from].text) &&
           (s.tokens[from + 1].is_word() || s.tokens[from + 1].is("["));
}

int array_length(const OwnStructure &s, std::size_t open) {
    const std::size_t close = s.partner[open];
    if (close == open + 1) {
        return 1; // as long as what it is made of, which stands in the text
    }
    const OwnToken &length = s.tokens[open + 1];
    int number = 0;
    const char *end = length.text.data() + length.text.size();
    const auto [read, error] = std::from_chars(length.text.data(), end, number);
    if (close == open + 2 && length.is("light_count")) {
        return most_lights;
    }
    if (close != open + 2 || error != std::errc() || read != end || number < 1 || number > longest_own_array) {
        s.refuse(length, fmt::format("the length of an array: expected a number from 1 to {}, or light_count",
                                     longest_own_array));
    }
    return number;
}

} // namespace

bool OwnStructure::is_type(const std::string &word) const {
    static const std::set<std::string, std::less<>> types{
        "float",  "int",    "uint",   "bool",   "vec2",   "vec3",   "vec4",   "ivec2",  "ivec3", "ivec4",
        "uvec2",  "uvec3",  "uvec4",  "bvec2",  "bvec3",  "bvec4",  "mat2",   "mat3",   "mat4",  "mat2x2",
        "mat2x3", "mat2x4", "mat3x2", "mat3x3", "mat3x4", "mat4x2", "mat4x3", "mat4x4", "Light", "Material",
        "double", "dvec2",  "dvec3",  "dvec4",  "dmat2",  "dmat3",  "dmat4"};
    return types.contains(word) || std::ranges::find(structs, word, &OwnStruct::name) != structs.end();
}

int OwnStructure::numbers_in(const std::string &type) const {
    constexpr int most_in_a_field = 16;
    const auto found = std::ranges::find(structs, type, &OwnStruct::name);
    if (found != structs.end()) {
        return most_in_a_field * found->fields;
    }
    const bool of_the_interface = type == "Light" || type == "Material";
    if (of_the_interface || type.starts_with("mat")) {
        return of_the_interface ? 32 : most_in_a_field;
    }
    const char last = type.empty() ? '1' : type.back(); // "a[2]b[3]" names no type: the compiler will say so
    return last >= '2' && last <= '4' ? last - '0' : 1;
}

OwnStructure own_structure(std::vector<OwnToken> tokens, const std::string &file) {
    OwnStructure s{file, std::move(tokens), {}, {}, {}};
    pair_brackets(s);
    find_structs(s);
    find_functions(s);
    return s;
}

void refuse_large_arrays(const OwnStructure &s) {
    long numbers = 0;
    bool declaration = declares(s, 0);
    std::string type;
    int depth = 0;
    int statement_depth = 0;
    for (std::size_t i = 0; i < s.tokens.size(); ++i) {
        const OwnToken &token = s.tokens[i];
        const bool for_begins = token.is("(") && i > 0 && s.tokens[i - 1].is("for");
        depth += token.is("(") ? 1 : token.is(")") ? -1 : 0;
        if (token.is(";") || token.is("{") || token.is("}") || for_begins) {
            declaration = declares(s, i + 1);
            statement_depth = depth;
        }
        type = token.is_word() && s.is_type(token.text) ? token.text : type; // the nearest before the bracket
        if (!token.is("[") || i == 0) {
            continue;
        }
        const bool after_type = s.tokens[i - 1].is_word() && s.is_type(s.tokens[i - 1].text);
        const bool named = i > 1 && s.tokens[i - 1].is_word();
        const bool first = named && s.tokens[i - 2].is_word() && s.is_type(s.tokens[i - 2].text);
        const bool another = named && declaration && depth == statement_depth && s.tokens[i - 2].is(",");
        const bool of_array_type = named && s.tokens[i - 2].is("]");
        if (after_type || first || another || of_array_type) {
            numbers += static_cast<long>(array_length(s, i)) * s.numbers_in(type);
        }
        if (numbers > most_array_numbers) {
            s.refuse(token, fmt::format("arrays of more than {} numbers together", most_array_numbers));
        }
    }
}

} // namespace sandbox
