#include "shading/template.h"

#include <sstream>
#include <stdexcept>
#include <vector>

namespace sandbox {
namespace {

std::string_view trim(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

class Expander {
  public:
    Expander(const ShaderParts &parts, const TemplateValues &values) : parts_(parts), values_(values) {}

    void expand(std::string_view part, const std::string &kind, int depth) {
        if (depth > 8) {
            throw std::logic_error(std::string(part) + ": parts include each other");
        }
        std::vector<Branch> branches;
        std::istringstream lines(parts_.text(part));
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number) {
            const Place place{part, kind, number};
            const auto words = trim(line);
            if (is_branch(words)) {
                branch(words, branches, place);
            } else if (branches.empty() || branches.back().active) {
                words.starts_with("#include") ? include(words, place, depth) : emit(line, place);
            }
        }
        if (!branches.empty()) {
            throw std::logic_error(std::string(part) + ": #if without #endif");
        }
    }

    StageSource take() { return std::move(result_); }

  private:
    struct Place {
        std::string_view part;
        const std::string &kind;
        int line;
    };
    struct Branch {
        bool outer;  ///< the lines around are kept
        bool taken;  ///< some arm was
        bool active; ///< this arm is
    };

    [[noreturn]] static void fail(const Place &place, const std::string &what) {
        throw std::logic_error(std::string(place.part) + ":" + std::to_string(place.line) + ": " + what);
    }

    static bool is_branch(std::string_view words) {
        return words.starts_with("#if ") || words.starts_with("#elif ") || words == "#else" || words == "#endif";
    }

    void branch(std::string_view words, std::vector<Branch> &branches, const Place &place) const {
        if (words.starts_with("#if ")) {
            const bool outer = branches.empty() || branches.back().active;
            const bool on = condition(words.substr(4), place);
            branches.push_back({outer, on, outer && on});
            return;
        }
        if (branches.empty()) {
            fail(place, "no #if before this");
        }
        Branch &top = branches.back();
        if (words == "#endif") {
            branches.pop_back();
        } else {
            const bool on = words == "#else" || condition(words.substr(6), place);
            top.active = top.outer && !top.taken && on;
            top.taken = top.taken || on;
        }
    }

    bool condition(std::string_view text, const Place &place) const {
        bool any = false;
        bool all = true;
        std::istringstream words{std::string(text)};
        for (std::string word; words >> word;) {
            if (word == "||") {
                any = any || all;
                all = true;
            } else if (word != "&&") {
                const bool negate = word.starts_with('!');
                all = (flag(std::string_view(word).substr(negate ? 1 : 0), place) != negate) && all;
            }
        }
        return any || all;
    }

    static std::string resolve(std::string_view name, const Place &place) {
        if (name.starts_with("light.") && !place.kind.empty()) {
            return place.kind + std::string(name.substr(5));
        }
        return std::string(name);
    }

    bool flag(std::string_view name, const Place &place) const {
        const auto found = values_.flags.find(resolve(name, place));
        if (found == values_.flags.end()) {
            fail(place, "no flag '" + resolve(name, place) + "'");
        }
        return found->second;
    }

    void include(std::string_view words, const Place &place, int depth) {
        const auto open = words.find('"');
        const auto close = words.find('"', open + 1);
        if (open == std::string_view::npos || close == std::string_view::npos) {
            fail(place, "expected #include \"part.glsl\"");
        }
        const auto rest = trim(words.substr(close + 1));
        const std::string kind = rest.starts_with("with ") ? std::string(trim(rest.substr(5))) : place.kind;
        expand(words.substr(open + 1, close - open - 1), kind, depth + 1);
    }

    void emit(const std::string &line, const Place &place) {
        std::string text;
        std::size_t from = 0;
        for (auto at = line.find("${"); at != std::string::npos; at = line.find("${", from)) {
            const auto end = line.find('}', at);
            const auto name = resolve(std::string_view(line).substr(at + 2, end - at - 2), place);
            const auto found = values_.texts.find(name);
            if (found == values_.texts.end()) {
                fail(place, "no text '" + name + "'");
            }
            text += line.substr(from, at - from) + found->second;
            from = end + 1;
        }
        text += line.substr(from);
        const bool blank = trim(text).empty();
        if (blank && (last_blank_ || result_.origins.empty())) {
            return;
        }
        last_blank_ = blank;
        result_.text += text + "\n";
        result_.origins.push_back({std::string(place.part), place.line});
    }

    const ShaderParts &parts_;
    const TemplateValues &values_;
    StageSource result_;
    bool last_blank_ = false;
};

} // namespace

StageSource expand(const ShaderParts &parts, std::string_view part, const TemplateValues &values) {
    Expander expander(parts, values);
    expander.expand(part, {}, 0);
    return expander.take();
}

} // namespace sandbox
