#pragma once

#include "shading/parts.h"
#include "shading/program_source.h"

#include <map>
#include <string>

namespace sandbox {

/// What a part's directives may ask for. Names are dotted: "point.diffuse".
struct TemplateValues {
    std::map<std::string, bool, std::less<>> flags;
    std::map<std::string, std::string, std::less<>> texts;
};

/// Expands `part` and what it includes. Lines that begin with
///   #if A && !B || C, #elif, #else, #endif   keep or drop lines (&& binds tighter; flags)
///   #include "part.glsl" [with KIND]         expand another part; with: `light.x` means `KIND.x` inside it
/// are directives and leave no line behind; ${name} is replaced by a text. Names that are not known, and unbalanced
/// directives, throw std::logic_error naming part:line. Runs of blank lines become one.
StageSource expand(const ShaderParts &parts, std::string_view part, const TemplateValues &values);

} // namespace sandbox
