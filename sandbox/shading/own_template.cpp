#include "shading/own_template.h"

#include "shading/own_interface.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

/// The own text under the declarations that it asks for.
StageSource own_source(const OwnText &text, int lights) {
    StageSource source;
    for (const std::string &line : own_declarations(text, lights)) {
        source.text += line + "\n";
        source.origins.push_back({"own_shading.glsl", 0});
    }
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
        source.text += text.lines[i] + "\n";
        source.origins.push_back({text.file, static_cast<int>(i) + 1});
    }
    return source;
}

/// What lighting() is called with; what it does not read is not found first.
std::string arguments(const StageNeeds &stage, const OwnText &text, std::string_view P, std::string_view N) {
    constexpr std::string_view unread = "vec3(0.0)";
    return fmt::format("{}, {}, {}", stage.P ? P : unread, stage.N ? N : unread, text.reads_eye ? "eye" : unread);
}

void replace_program(TemplateValues &values, const Features &f, const ProgramNeeds &needs) {
    const OwnText &text = *f.technique.own;
    const bool at_vertices = needs.vertex.lit;
    const bool in_vertex_stage = at_vertices || (text.position && needs.vertex.P) || (text.normal && needs.vertex.N);
    auto &flags = values.flags;
    flags["own.at_vertices"] = in_vertex_stage;
    flags["own.pixels"] = !at_vertices;
    flags["own.apart"] = needs.vertex.separate_specular;
    flags["reads_model"] = (needs.vertex.P && !text.position) || f.normal_transform == NormalTransform::rigid;
    flags["reads_normal_matrix"] = // own shading declares what it names
        f.normal_transform == NormalTransform::general && !(in_vertex_stage && text.names("normal_matrix"));
    flags["reads_eye"] = text.reads_eye && at_vertices;
    flags["fragment.reads_eye"] = text.reads_eye && !at_vertices;
    auto &texts = values.texts;
    texts["fragment.surface_arguments"] = arguments(needs.fragment, text, "v_position", "N");
    texts["vertex.surface_arguments"] = arguments(needs.vertex, text, "P", "N");
    texts["vertex.back_arguments"] = arguments(needs.vertex, text, "P", "-N");
    const std::string light = !at_vertices ? "light" : needs.both_sides ? "vertex_light" : "v_light";
    const std::string apart = needs.both_sides ? "vertex_specular" : "v_specular";
    texts["fragment.color"] = needs.vertex.separate_specular ? fmt::format("base * {} + {}", light, apart) : light;
    values.given.emplace("own text", own_source(text, f.own.lights));
}

} // namespace

void add_own_shading(TemplateValues &values, const Features &f, const ProgramNeeds &needs) {
    const OwnText *text = f.is_own() ? &*f.technique.own : nullptr;
    values.flags.insert({{"own", text != nullptr},
                         {"own.at_vertices", false},
                         {"own.position", text != nullptr && text->position},
                         {"own.normal", text != nullptr && text->normal},
                         {"own.moved", f.own.moved},
                         {"own.base", text != nullptr && text->base},
                         {"own.pixels", false},
                         {"own.apart", false}});
    if (text != nullptr) {
        replace_program(values, f, needs);
    }
}

} // namespace sandbox
