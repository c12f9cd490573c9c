#pragma once

#include "shading/features.h"
#include "shading/template.h"

namespace sandbox {

/// What the parts may ask of one stage of the specialised program with these features.
TemplateValues specialised_values(const Features &features, Stage stage);

/// The same for the full program of the features' frequency, which asks for little.
TemplateValues full_values(const Features &features, Stage stage);

} // namespace sandbox
