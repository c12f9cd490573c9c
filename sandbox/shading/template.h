#pragma once

#include "shading/parts.h"
#include "shading/program_source.h"

#include <functional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace sandbox {

/// Looks names up without copying them.
struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>{}(name); }
};
template <class T> using ByName = std::unordered_map<std::string, T, NameHash, std::equal_to<>>;

/// What a part's directives may ask for. Names are dotted: "point.diffuse".
struct TemplateValues {
    ByName<bool> flags;
    ByName<std::string> texts;
    ByName<std::vector<std::string>> lists;     ///< what #each goes through; none is empty
    ByName<StageSource> given{};                ///< what #include takes as it is, in place of a part of this name
    std::set<std::string, std::less<>> choices; ///< flags that only the running program knows, as uniform bools
};

/// Expands `part` and what it includes. Lines that begin with
///   #if A && !B || C, #elif, #else, #endif   keep or drop lines by flags (&& binds tighter)
///   #include "part.glsl"                     expand another part
///   #each NAME, #end                         repeat lines for every word of a list; in them `NAME.x` means `WORD.x`
///   #choices                                 declare the choices that the text reads
/// are directives and leave no line behind; ${name} is replaced by a text. An #if on a choice becomes an `if` of GLSL;
/// what several of its arms declare is declared before it. Names that are not known, and unbalanced directives, throw
/// std::logic_error naming part:line. Runs of blank lines become one.
StageSource expand(const ShaderParts &parts, std::string_view part, const TemplateValues &values);

/// The uniform that a choice is: "point_narrow_cone" of "point.narrow_cone".
std::string uniform_name(std::string_view choice);

} // namespace sandbox
