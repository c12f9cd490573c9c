#include "shading/template.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <stdexcept>
#include <unordered_set>

namespace sandbox {
namespace {

std::string_view trim(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        const auto end = std::min(text.find(separator), text.size());
        pieces.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + separator.size(), text.size()));
    }
    return pieces;
}

struct Line {
    std::string text;
    LineOrigin origin;
};
using Lines = std::vector<Line>;

/// What is known of a condition while a program is assembled: that it is on, or an expression that decides, or neither.
struct Condition {
    bool on = false;
    std::string glsl;
};

/// Lines under a condition that the running program decides; the last arm may have none.
struct Arm {
    std::string condition;
    Lines lines;
};

/// The end of the identifier or keyword that begins at `from`.
std::size_t end_of_word(std::string_view text, std::size_t from) {
    const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    return static_cast<std::size_t>(
        std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), in_word) - text.begin());
}

/// "vec3 base" of "    vec3 base = ..."; empty if the line declares no vec3 or float.
std::string_view declaration(std::string_view line) {
    line = trim(line);
    const bool typed = line.starts_with("float ") || line.starts_with("vec3 ");
    const std::size_t end = typed ? end_of_word(line, line.find(' ') + 1) : 0;
    return line.substr(end).starts_with(" = ") ? line.substr(0, end) : std::string_view{};
}

/// The declarations of variables that more than one arm declares: what follows the arms reads these.
std::set<std::string, std::less<>> shared_declarations(const std::vector<Arm> &arms) {
    std::set<std::string_view> seen;
    std::set<std::string, std::less<>> shared;
    for (const Arm &arm : arms) {
        for (const Line &line : arm.lines) {
            const std::string_view declared = declaration(line.text);
            if (!declared.empty() && !seen.insert(declared).second) {
                shared.emplace(declared);
            }
        }
    }
    return shared;
}

/// The arms as an `if` of GLSL, whose own lines come from where its first arm comes from.
void add_run_time_branches(Lines &out, std::vector<Arm> arms) {
    const LineOrigin origin = arms.front().lines.front().origin;
    const std::string &first = arms.front().lines.front().text;
    const std::string indent(std::min(first.find_first_not_of(' '), first.size()), ' ');
    const auto add = [&](const std::string &text) { out.push_back({indent + text, origin}); };
    const auto shared = shared_declarations(arms);
    for (const std::string &declared : shared) {
        add(declared + ";");
    }
    std::string begin;
    for (Arm &arm : arms) {
        add(arm.condition.empty() ? begin + "{" : begin + "if (" + arm.condition + ") {");
        begin = "} else ";
        for (Line &line : arm.lines) {
            if (const std::string_view declared = declaration(line.text); shared.contains(declared)) {
                line.text.erase(line.text.find(declared), declared.find(' ') + 1);
            }
            if (!line.text.empty()) {
                line.text.insert(0, "    ");
            }
            out.push_back(std::move(line));
        }
    }
    add("}");
}

constexpr std::string_view choices_mark = "#choices";

class Expander {
  public:
    Expander(const ShaderParts &parts, const TemplateValues &values) : parts_(parts), values_(values) {}

    void expand(std::string_view name, Lines *out) {
        if (depth_ > 8) {
            throw std::logic_error(fmt::format("{}: parts include each other", name));
        }
        Part part{name, split(parts_.text(name), "\n")};
        ++depth_;
        read(part, out);
        --depth_;
        if (!part.at_end()) {
            fail(part, part.words() == "#end" ? "no #each before this" : "no #if before this");
        }
    }

  private:
    /// A part's lines, and the one that is read next.
    struct Part {
        std::string_view name;
        std::vector<std::string_view> lines;
        std::size_t next = 0;

        [[nodiscard]] bool at_end() const { return next == lines.size(); }
        [[nodiscard]] std::string_view words() const { return trim(lines[next]); }
        [[nodiscard]] std::string_view argument() const { return trim(words().substr(words().find(' '))); }
        [[nodiscard]] LineOrigin origin() const { return {std::string(name), static_cast<int>(next) + 1}; }
    };

    [[noreturn]] static void fail(const Part &part, const std::string &what) {
        throw std::logic_error(fmt::format("{}:{}: {}", part.name, part.next + 1, what));
    }

    static bool closes_block(std::string_view words) {
        return words.starts_with("#elif ") || words == "#else" || words == "#endif" || words == "#end";
    }

    /// Up to the line that closes the block, or the part's end. Without `out` names are checked, and lines dropped.
    void read(Part &part, Lines *out) {
        while (!part.at_end() && !closes_block(part.words())) {
            if (part.words().starts_with("#if ")) {
                read_branches(part, out);
            } else if (part.words().starts_with("#each ")) {
                read_each(part, out);
            } else {
                if (out != nullptr) {
                    read_line(part, *out);
                }
                ++part.next;
            }
        }
    }

    void read_branches(Part &part, Lines *out) {
        std::vector<Arm> arms;
        bool decided = false;
        while (part.words() != "#endif") {
            const Condition is = part.words() == "#else" ? Condition{true, {}} : condition(part);
            const bool possible = !decided && (is.on || !is.glsl.empty()) &&
                                  std::ranges::find(arms, is.glsl, &Arm::condition) == arms.end();
            ++part.next;
            Arm arm{is.glsl, {}};
            read(part, out != nullptr && possible ? &arm.lines : nullptr);
            if (part.at_end() || part.words() == "#end") {
                throw std::logic_error(fmt::format("{}: #if without #endif", part.name));
            }
            if (possible) {
                arms.push_back(std::move(arm));
            }
            decided = decided || is.on;
        }
        ++part.next;
        if (out == nullptr || arms.empty()) {
            return;
        }
        if (arms.front().condition.empty()) {
            std::ranges::move(arms.front().lines, std::back_inserter(*out));
        } else if (!arms.front().lines.empty()) {
            add_run_time_branches(*out, std::move(arms));
        }
    }

    void read_each(Part &part, Lines *out) {
        const std::string name(part.argument());
        const auto list = values_.lists.find(name);
        if (list == values_.lists.end()) {
            fail(part, fmt::format("no list '{}'", name));
        }
        const std::size_t first = part.next + 1;
        for (const std::string &word : list->second) {
            part.next = first;
            words_[name] = word;
            read(part, out);
        }
        words_.erase(name);
        if (part.at_end() || part.words() != "#end") {
            throw std::logic_error(fmt::format("{}: #each without #end", part.name));
        }
        ++part.next;
    }

    void read_line(const Part &part, Lines &out) {
        const std::string_view words = part.words();
        if (words.starts_with("#include ")) {
            const std::string quoted = replace_texts(part, part.argument());
            if (quoted.size() < 3 || quoted.front() != '"' || quoted.back() != '"') {
                fail(part, "expected #include \"part.glsl\"");
            }
            if (const auto given = values_.given.find(std::string_view(quoted).substr(1, quoted.size() - 2));
                given != values_.given.end()) {
                add_given(given->second, out);
                return;
            }
            expand(std::string_view(quoted).substr(1, quoted.size() - 2), &out);
        } else {
            out.push_back({replace_texts(part, part.lines[part.next]), part.origin()});
        }
    }

    static void add_given(const StageSource &given, Lines &out) {
        std::string_view text = given.text;
        for (const LineOrigin &origin : given.origins) {
            const std::size_t end = text.find('\n');
            out.push_back({std::string(text.substr(0, end)), origin});
            text.remove_prefix(end + 1);
        }
    }

    [[nodiscard]] Condition condition(const Part &part) const {
        Condition any;
        for (const std::string_view alternative : split(part.argument(), "||")) {
            bool possible = true;
            std::string chosen;
            for (std::string_view name : split(alternative, "&&")) {
                name = trim(name);
                const bool negated = name.starts_with('!');
                const std::string flag = resolve(name.substr(negated ? 1 : 0));
                if (values_.choices.contains(flag)) {
                    chosen.append(chosen.empty() ? "" : " && ").append(negated ? "!" : "").append(uniform_name(flag));
                } else {
                    possible = (is_on(flag, part) != negated) && possible;
                }
            }
            any.on |= possible && chosen.empty();
            if (possible && !chosen.empty()) {
                any.glsl.append(any.glsl.empty() ? "" : " || ").append(chosen);
            }
        }
        return any.on ? Condition{true, {}} : any;
    }

    [[nodiscard]] std::string resolve(std::string_view name) const {
        const auto dot = std::min(name.find('.'), name.size());
        const auto word = words_.find(name.substr(0, dot));
        return word == words_.end() ? std::string(name) : word->second + std::string(name.substr(dot));
    }

    [[nodiscard]] bool is_on(const std::string &name, const Part &part) const {
        const auto found = values_.flags.find(name);
        if (found == values_.flags.end()) {
            fail(part, fmt::format("no flag '{}'", name));
        }
        return found->second;
    }

    [[nodiscard]] std::string replace_texts(const Part &part, std::string_view line) const {
        std::string text;
        for (auto at = line.find("${"); at != std::string_view::npos; at = line.find("${")) {
            const auto end = line.find('}', at);
            const std::string name = resolve(line.substr(at + 2, end - at - 2));
            const auto found = values_.texts.find(name);
            if (found == values_.texts.end()) {
                fail(part, fmt::format("no text '{}'", name));
            }
            text.append(line.substr(0, at)).append(found->second);
            line.remove_prefix(end + 1);
        }
        return text.append(line);
    }

    const ShaderParts &parts_;
    const TemplateValues &values_;
    std::map<std::string, std::string, std::less<>> words_; ///< what the names of #each stand for
    int depth_ = 0;
};

/// The names that the lines hold; they lie in the lines' texts.
std::unordered_set<std::string_view> identifiers(const Lines &lines) {
    std::unordered_set<std::string_view> found;
    for (const Line &line : lines) {
        const std::string_view text = line.text;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = end_of_word(text, at);
            if (end > at) {
                found.insert(text.substr(at, end - at));
            }
            at = std::max(end, at + 1);
        }
    }
    return found;
}

} // namespace

std::string uniform_name(std::string_view choice) {
    std::string name(choice);
    std::ranges::replace(name, '.', '_');
    return name;
}

StageSource expand(const ShaderParts &parts, std::string_view part, const TemplateValues &values) {
    Lines lines;
    Expander(parts, values).expand(part, &lines);
    StageSource result;
    bool after_blank = true;
    const auto add = [&](const std::string &text, const LineOrigin &origin) {
        const bool blank = trim(text).empty();
        if (!(blank && after_blank)) {
            result.text += text + "\n";
            result.origins.push_back(origin);
        }
        after_blank = blank;
    };
    for (const auto &[text, origin] : lines) {
        if (text != choices_mark) {
            add(text, origin);
            continue;
        }
        const auto read = identifiers(lines);
        for (const std::string &choice : values.choices) {
            if (const std::string name = uniform_name(choice); read.contains(name)) {
                add(fmt::format("uniform bool {};", name), origin);
            }
        }
    }
    return result;
}

} // namespace sandbox
