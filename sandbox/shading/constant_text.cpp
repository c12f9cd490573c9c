#include "shading/constant_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <sstream>
#include <string_view>
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

/// "uniform vec3 two[2]; // comment"
struct Declaration {
    std::string type, name;
    int count = 0; ///< of an array's elements; 0: no array
    std::string rest;
};

/// Of a line that declares one uniform, or one member of a struct.
std::optional<Declaration> declaration(std::string_view line, std::string_view before) {
    const std::size_t end = line.find(';');
    if (!line.starts_with(before) || end == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view declared = line.substr(before.size(), end - before.size());
    const std::size_t space = declared.find(' '), bracket = declared.find('[');
    if (space == std::string_view::npos || declared.find(',') != std::string_view::npos) {
        return std::nullopt;
    }
    const bool is_array = bracket != std::string_view::npos;
    const std::string_view name = declared.substr(space + 1, is_array ? bracket - space - 1 : bracket);
    return Declaration{std::string(declared.substr(0, space)), std::string(name),
                       is_array ? std::stoi(std::string(declared.substr(bracket + 1))) : 0,
                       std::string(line.substr(end + 1))};
}

/// One line of the text an entry; none where some element has no value.
std::vector<std::string> constant(const Declaration &uniform, const Structs &structs, const UniformValues &values) {
    const auto &[type, name, count, rest] = uniform;
    if (count == 0) {
        const auto value = element(type, name, structs, values);
        return value ? std::vector{fmt::format("const {} {} = {};{}", type, name, *value, rest)}
                     : std::vector<std::string>{};
    }
    std::vector<std::string> lines{fmt::format("const {0} {1}[{2}] = {0}[{2}]({3}", type, name, count, rest)};
    for (int i = 0; i < count; ++i) {
        const auto value = element(type, fmt::format("{}[{}]", name, i), structs, values);
        if (!value) {
            return {};
        }
        lines.push_back("    " + *value + (i + 1 < count ? "," : ");"));
    }
    return lines;
}

StageSource with_constants(const StageSource &source, const UniformValues &values) {
    Structs structs;
    std::string open; // the struct whose members are read
    StageSource result;
    std::istringstream text(source.text);
    std::size_t number = 0;
    for (std::string line; std::getline(text, line); ++number) {
        std::vector<std::string> lines{line};
        if (const auto uniform = declaration(line, "uniform ")) {
            if (auto constants = constant(*uniform, structs, values); !constants.empty()) {
                lines = std::move(constants);
            }
        } else if (line.starts_with("struct ")) {
            open = line.substr(7, line.find(' ', 7) - 7);
        } else if (line == "};") {
            open.clear();
        } else if (const auto member = open.empty() ? std::nullopt : declaration(line, "    ")) {
            structs[open].push_back({member->type, member->name});
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
