#pragma once

#include "shading/needs.h"
#include "shading/template.h"

#include <string>

/// What the parts may ask about the lights of one kind.
namespace sandbox {

/// The lights of one kind, seen from one stage.
struct LightPart {
    const LightKind &kind;
    const Features &program;
    const StageNeeds &stage;
    const LightFeatures &features;
    const LightNeeds &here; ///< in this stage
    bool rounded;           ///< its operations are rounded to half, in the textbook's order
};

/// The array that holds the lights of a kind, and what is interpolated of them.
void add_array(TemplateValues &values, const LightKind &kind, const Features &program, const LightFeatures &has,
               const LightNeeds &handed);

/// The function of a kind's lights in one stage.
void add_light(TemplateValues &values, const LightPart &light);

/// The uniform that holds the light at `index` of its kind, or of all lights in a full program: "the_point_light",
/// "spot_lights[1]", "lights[5]".
std::string light_uniform(const Features &program, const LightKind &kind, const std::string &index);

} // namespace sandbox
