#include "shading/program_source.h"

#include "shading/rounded_text.h"
#include "shading/template_values.h"

#include <fmt/format.h>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace sandbox {

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
    // Mesa "0:31(5): error", NVIDIA "0(31) : error", Intel and AMD "ERROR: 0:31: ..."
    static const std::regex place(R"(\b0(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:)");
    std::istringstream lines(log);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, place)) {
            const auto number = std::stoul(match[1].matched ? match[1].str() : match[2].str());
            if (number >= 1 && number <= source.origins.size()) {
                const LineOrigin &origin = source.origins[number - 1];
                line = fmt::format("{}{}:{}:{}", match.prefix().str(), origin.part, origin.line, match.suffix().str());
            }
        }
        result += line + "\n";
    }
    return result;
}

} // namespace sandbox
