#include "shading/program_source.h"

#include "shading/rounded_text.h"
#include "shading/template_values.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace sandbox {
namespace {

/// Where a log names a line of the text, up to the colon behind it.
struct LogPlace {
    std::size_t begin = 0, end = 0;
    std::size_t line = 0;
};

/// Takes `c` from the front of `text`, if it is there.
bool take(std::string_view &text, char c) {
    const bool there = text.starts_with(c);
    text.remove_prefix(there ? 1 : 0);
    return there;
}

/// Takes digits; false if there are none.
bool take_number(std::string_view &text, std::size_t &number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc();
}

/// Mesa "0:31(5): error", NVIDIA "0(31) : error", Intel and AMD "ERROR: 0:31: ..."
std::optional<LogPlace> find_place(std::string_view log) {
    for (std::size_t at = log.find('0'); at != std::string_view::npos; at = log.find('0', at + 1)) {
        std::string_view rest = log.substr(at + 1);
        LogPlace place{at, 0, 0};
        std::size_t column = 0;
        const bool begins =
            at == 0 || (std::isalnum(static_cast<unsigned char>(log[at - 1])) == 0 && log[at - 1] != '_');
        const bool found = take(rest, ':') ? take_number(rest, place.line) &&
                                                 (!take(rest, '(') || (take_number(rest, column) && take(rest, ')')))
                                           : take(rest, '(') && take_number(rest, place.line) && take(rest, ')');
        while (take(rest, ' ')) {
        }
        if (begins && found && take(rest, ':')) {
            place.end = log.size() - rest.size();
            return place;
        }
    }
    return std::nullopt;
}

} // namespace

ProgramSource assemble(const Features &program, const ShaderParts &parts) {
    const ProgramNeeds needs = derive_needs(program);
    TemplateValues values = template_values(program, needs, Stage::vertex);
    StageSource vertex = expand(parts, "vertex.glsl", values);
    choose_stage(values, program, needs, Stage::fragment);
    StageSource fragment = expand(parts, "fragment.glsl", values);
    const bool rounded = program.technique.precision == Precision::medium;
    return {std::move(vertex), rounded ? with_rounded_operations(std::move(fragment)) : std::move(fragment)};
}

StageSource in_es(StageSource source) {
    constexpr std::string_view core = "#version 330 core\n";
    if (!source.text.starts_with(core)) {
        throw std::logic_error("a stage begins with its version");
    }
    source.text.replace(0, core.size(),
                        "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
                        "#line 2\n");
    return source;
}

std::string map_log(const std::string &log, const StageSource &source) {
    std::istringstream lines(log);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const auto place = find_place(line);
        if (place && place->line >= 1 && place->line <= source.origins.size()) {
            const LineOrigin &origin = source.origins[place->line - 1];
            line = fmt::format("{}{}:{}:{}", line.substr(0, place->begin), origin.part, origin.line,
                               line.substr(place->end));
        }
        result += line + "\n";
    }
    return result;
}

} // namespace sandbox
