#include "shading/constant_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <regex>
#include <sstream>
#include <vector>

namespace sandbox {
namespace {

struct Member {
    std::string type, name;
};
using Structs = std::map<std::string, std::vector<Member>, std::less<>>;

std::string literal(float number) {
    std::string text = fmt::format("{}", number);
    if (text.find_first_of(".e") == std::string::npos) {
        text += ".0";
    }
    return text;
}

/// Nothing where the uniform has no value, or one that no literal can hold.
std::optional<std::string> literal(const std::string &type, const std::string &name, const UniformValues &values) {
    const auto found = values.find(name);
    if (found == values.end()) {
        return std::nullopt;
    }
    std::vector<std::string> numbers;
    for (int i = 0; i < found->second.count; ++i) {
        const float number = found->second.numbers[static_cast<std::size_t>(i)];
        if (!std::isfinite(number)) {
            return std::nullopt;
        }
        numbers.push_back(literal(number));
    }
    return type == "float" ? numbers.at(0) : fmt::format("{}({})", type, fmt::join(numbers, ", "));
}

/// Of one element: a number, a vector, or a struct of them.
std::optional<std::string> element(const std::string &type, const std::string &name, const Structs &structs,
                                   const UniformValues &values) {
    const auto found = structs.find(type);
    if (found == structs.end()) {
        return literal(type, name, values);
    }
    std::vector<std::string> members;
    for (const Member &member : found->second) {
        const auto text = literal(member.type, fmt::format("{}.{}", name, member.name), values);
        if (!text) {
            return std::nullopt;
        }
        members.push_back(*text);
    }
    return fmt::format("{}({})", type, fmt::join(members, ", "));
}

/// One line of the text an entry; none where some element has no value.
std::vector<std::string> constant(const std::smatch &uniform, const Structs &structs, const UniformValues &values) {
    const std::string type = uniform[1], name = uniform[2], count = uniform[3], rest = uniform[4];
    if (count.empty()) {
        const auto value = element(type, name, structs, values);
        return value ? std::vector{fmt::format("const {} {} = {};{}", type, name, *value, rest)}
                     : std::vector<std::string>{};
    }
    std::vector<std::string> lines{fmt::format("const {0} {1}[{2}] = {0}[{2}]({3}", type, name, count, rest)};
    const int elements = std::stoi(count);
    for (int i = 0; i < elements; ++i) {
        const auto value = element(type, fmt::format("{}[{}]", name, i), structs, values);
        if (!value) {
            return {};
        }
        lines.push_back("    " + *value + (i + 1 < elements ? "," : ");"));
    }
    return lines;
}

StageSource with_constants(const StageSource &source, const UniformValues &values) {
    static const std::regex uniform(R"(uniform (\w+) (\w+)(?:\[(\d+)\])?;(.*))");
    static const std::regex begin(R"(struct (\w+) \{)");
    static const std::regex member(R"(    (\w+) (\w+);.*)");
    Structs structs;
    std::string open; // the struct whose members are read
    StageSource result;
    std::istringstream text(source.text);
    std::size_t number = 0;
    for (std::string line; std::getline(text, line); ++number) {
        std::vector<std::string> lines{line};
        if (std::smatch match; std::regex_match(line, match, uniform)) {
            if (auto constants = constant(match, structs, values); !constants.empty()) {
                lines = std::move(constants);
            }
        } else if (std::regex_match(line, match, begin)) {
            open = match[1];
        } else if (line == "};") {
            open.clear();
        } else if (!open.empty() && std::regex_match(line, match, member)) {
            structs[open].push_back({match[1], match[2]});
        }
        for (const std::string &each : lines) {
            result.text += each + "\n";
            result.origins.push_back(source.origins[number]);
        }
    }
    return result;
}

} // namespace

ProgramSource with_constants(ProgramSource source, const UniformValues &values) {
    return values.empty()
               ? std::move(source)
               : ProgramSource{with_constants(source.vertex, values), with_constants(source.fragment, values)};
}

} // namespace sandbox
