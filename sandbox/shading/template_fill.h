#pragma once

#include "shading/technique.h"
#include "shading/template.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What fills TemplateValues.
namespace sandbox {

using Flags = std::initializer_list<std::pair<std::string_view, bool>>;
using Texts = std::initializer_list<std::pair<std::string_view, std::string>>;

/// The kind "point" makes "point.diffuse" of "diffuse".
std::string dotted(std::string_view kind, std::string_view name);
void add_flags(TemplateValues &values, std::string_view kind, const Flags &flags);
void add_texts(TemplateValues &values, std::string_view kind, const Texts &texts);

/// Terms joined into one sum; `none` where there are none.
std::string sum_of(const std::vector<std::string> &terms, const std::string &none = "");
/// ... in brackets, where there are more than one.
std::string in_brackets(const std::vector<std::string> &terms);

/// A value of a technique key as its GLSL names it: "blinn_phong".
std::string glsl_name(const TechniqueValue &value);
std::string glsl_name(Model model);

} // namespace sandbox
