#include "shading/template_fill.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandbox {

std::string dotted(std::string_view kind, std::string_view name) { return std::string(kind).append(".").append(name); }

void add_flags(TemplateValues &values, std::string_view kind, const Flags &flags) {
    for (const auto &[name, on] : flags) {
        values.flags[dotted(kind, name)] = on;
    }
}

void add_texts(TemplateValues &values, std::string_view kind, const Texts &texts) {
    for (const auto &[name, text] : texts) {
        values.texts[dotted(kind, name)] = text;
    }
}

std::string sum_of(const std::vector<std::string> &terms, const std::string &none) {
    return terms.empty() ? none : fmt::format("{}", fmt::join(terms, " + "));
}

std::string in_brackets(const std::vector<std::string> &terms) {
    return terms.size() > 1 ? "(" + sum_of(terms) + ")" : sum_of(terms);
}

std::string glsl_name(const TechniqueValue &value) {
    std::string name(value.name);
    std::ranges::replace(name, '-', '_');
    return name;
}

std::string glsl_name(Model model) { return glsl_name(model_values[static_cast<std::size_t>(model)]); }

} // namespace sandbox
