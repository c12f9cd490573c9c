#include "shading/program_source.h"
#include "shading/template_values.h"

namespace sandbox {

ProgramSource assemble(const Features &features, const ShaderParts &parts) {
    return {expand(parts, "vertex.glsl", specialised_values(features, Stage::vertex)),
            expand(parts, "fragment.glsl", specialised_values(features, Stage::fragment))};
}

} // namespace sandbox
