#include "shading/program_source.h"
#include "shading/template_values.h"

namespace sandbox {

TemplateValues full_values(const Features &f, Stage stage) {
    const bool hybrid = f.frequency == Frequency::hybrid;
    const bool vectors = f.frequency == Frequency::interpolated_vectors;
    const bool flat = f.frequency == Frequency::flat;
    const bool vertex_lit = flat || hybrid || f.frequency == Frequency::per_vertex;
    TemplateValues values;
    values.flags = {{"flat", flat},
                    {"hybrid", hybrid},
                    {"vectors", vectors},
                    {"vertex_lit", vertex_lit},
                    {"fragment_lit", !vertex_lit || hybrid},
                    {"deep", f.deep},
                    {"wide", f.wide},
                    {"object_ids", f.object_ids}};
    values.texts = {
        {"way", stage == Stage::vertex ? "out" : "in"},
        {"flat", flat ? "flat " : ""},
        {"full.point", flat ? "a_centroid" : "a_position"},
        {"full.lights", std::to_string(vectors ? full_program_max_vector_lights : full_program_max_lights)}};
    return values;
}

ProgramSource assemble(const Features &features, const ShaderParts &parts) {
    if (features.program == Program::full) {
        return {expand(parts, "full_vertex.glsl", full_values(features, Stage::vertex)),
                expand(parts, "full_fragment.glsl", full_values(features, Stage::fragment))};
    }
    return {expand(parts, "vertex.glsl", specialised_values(features, Stage::vertex)),
            expand(parts, "fragment.glsl", specialised_values(features, Stage::fragment))};
}

} // namespace sandbox
