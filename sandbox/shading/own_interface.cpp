#include "shading/own_interface.h"

#include "scene/light_kind.h"
#include "scene/space.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace sandbox {
namespace {

float number(double value) { return static_cast<float>(value); }
glm::vec3 vector(const glm::dvec3 &value) { return glm::vec3(value); }
glm::vec3 unit(const glm::dvec3 &v) {
    const double length = glm::length(v);
    return length > 0 ? glm::vec3(v / length) : glm::vec3(0);
}
/// Exactly 0 at 90 degrees.
float cosine(double degrees) { return degrees == 90 ? 0 : number(std::cos(glm::radians(degrees))); }

using FromLight = OwnName<Light>;
constexpr FromLight light_fields[]{
    {"int", "type", "DIRECTIONAL, POINT or SPOT", [](const Light &l) -> OwnValue { return int(l.type); }},
    {"vec3", "color", "multiplies the three intensities", [](const Light &l) -> OwnValue { return vector(l.color); }},
    {"float", "ambient", "intensity", [](const Light &l) -> OwnValue { return number(l.ambient); }},
    {"float", "diffuse", "intensity", [](const Light &l) -> OwnValue { return number(l.diffuse); }},
    {"float", "specular", "intensity", [](const Light &l) -> OwnValue { return number(l.specular); }},
    {"bool", "attenuate_ambient", "attenuation and cone weaken the ambient term, too",
     [](const Light &l) -> OwnValue { return int(l.attenuate_ambient); }},
    {"vec3", "position", "of point and spot lights", [](const Light &l) -> OwnValue { return vector(l.position); }},
    {"vec3", "direction", "of directional and spot lights: unit, the way light travels",
     [](const Light &l) -> OwnValue { return has_direction(l) ? unit(l.direction) : glm::vec3(0); }},
    {"float", "constant", "attenuation: 1 / (constant + linear d + quadratic d^2)",
     [](const Light &l) -> OwnValue { return number(l.attenuation.constant); }},
    {"float", "linear", "", [](const Light &l) -> OwnValue { return number(l.attenuation.linear); }},
    {"float", "quadratic", "", [](const Light &l) -> OwnValue { return number(l.attenuation.quadratic); }},
    {"float", "cutoff_degrees", "half angle of a spot light's cone; 180: no cone",
     [](const Light &l) -> OwnValue { return number(l.cutoff_degrees); }},
    {"float", "cos_cutoff", "its cosine", [](const Light &l) -> OwnValue { return cosine(l.cutoff_degrees); }},
    {"float", "inner_cutoff_degrees", "where its soft edge begins; as cutoff_degrees: a hard edge",
     [](const Light &l) -> OwnValue { return number(l.inner_cutoff_degrees); }},
    {"float", "cos_inner_cutoff", "its cosine",
     [](const Light &l) -> OwnValue { return cosine(l.inner_cutoff_degrees); }},
    {"float", "exponent", "of the cone: cos^exponent of the angle from its axis",
     [](const Light &l) -> OwnValue { return number(l.exponent); }},
};

using FromMaterial = OwnName<Material>;
constexpr FromMaterial material_fields[]{
    {"vec3", "ambient", "", [](const Material &m) -> OwnValue { return vector(m.ambient); }},
    {"vec3", "diffuse", "", [](const Material &m) -> OwnValue { return vector(m.diffuse); }},
    {"vec3", "specular", "", [](const Material &m) -> OwnValue { return vector(m.specular); }},
    {"vec3", "emission", "", [](const Material &m) -> OwnValue { return vector(m.emission); }},
    {"float", "shininess", "the exponent n", [](const Material &m) -> OwnValue { return number(m.shininess); }},
    {"bool", "texture_modulates_specular", "base() multiplies the specular term, too",
     [](const Material &m) -> OwnValue { return int(m.texture_modulates_specular); }},
};

/// The inverse transpose or, of a matrix that has none, its cofactors: a normal's matrix still.
glm::mat3 normal_matrix(const Transform &transform) {
    const glm::dmat3 m = linear_part(transform);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double determinant = glm::dot(m[0], cofactors[0]);
    return std::abs(determinant) > 1e-30 ? glm::mat3(cofactors / determinant) : glm::mat3(cofactors);
}

glm::mat4 model_matrix(const Transform &transform) {
    glm::dmat4 m(linear_part(transform));
    m[3] = glm::dvec4(transform.translate, 1);
    return glm::mat4(m);
}

using FromSubject = OwnName<OwnSubject>;
constexpr FromSubject uniforms[]{
    {"vec3", "scene_ambient", "ambient light of the whole scene",
     [](const OwnSubject &s) -> OwnValue { return vector(s.scene.ambient); }},
    {"float", "blinn_exponent_scale", "Blinn-Phong raises to blinn_exponent_scale * shininess",
     [](const OwnSubject &s) -> OwnValue { return number(s.scene.blinn_exponent_scale); }},
    {"vec3", "view_axis", "unit, towards the camera along its axis: V under an orthographic camera",
     [](const OwnSubject &s) -> OwnValue { return vector(-camera_axes(s.scene.camera).forward); }},
    {"mat4", "model_matrix", "from model space to world space",
     [](const OwnSubject &s) -> OwnValue { return model_matrix(s.object.transform); }},
    {"mat3", "normal_matrix", "of normals: the inverse transpose of mat3(model_matrix)",
     [](const OwnSubject &s) -> OwnValue { return normal_matrix(s.object.transform); }},
};

std::string constant_of(const LightKind &kind) {
    std::string name(kind.word);
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return name;
}

/// "struct Light {", the fields that `wanted` picks, or else the first, and "};".
void add_struct(std::vector<std::string> &lines, std::string_view name, const auto &fields, const auto &wanted) {
    const bool none = std::ranges::none_of(fields, wanted);
    lines.push_back(fmt::format("struct {} {{", name));
    for (const auto &field : fields) {
        if (wanted(field) || (none && &field == &fields[0])) {
            lines.push_back(fmt::format("    {} {};", field.type, field.name));
        }
    }
    lines.emplace_back("};");
}

std::string comment(std::string_view indent, std::string_view declared, std::string_view doc) {
    return fmt::format("//   {}{}{}{}", indent, declared, doc.empty() ? "" : " // ", doc);
}

void add_struct_comment(std::vector<std::string> &lines, std::string_view name, const auto &fields) {
    lines.push_back(comment("", fmt::format("struct {} {{", name), ""));
    for (const auto &field : fields) {
        lines.push_back(comment("    ", fmt::format("{} {};", field.type, field.name), field.doc));
    }
    lines.push_back(comment("", "};", ""));
}

} // namespace

std::span<const FromLight> own_light_fields() { return light_fields; }
std::span<const FromMaterial> own_material_fields() { return material_fields; }
std::span<const FromSubject> own_uniforms() { return uniforms; }

std::vector<const Light *> own_lights(const Scene &scene) {
    std::vector<const Light *> lights;
    for (const Light &light : scene.lights) {
        if (light.enabled) {
            lights.push_back(&light);
        }
    }
    return lights;
}

std::vector<std::string> own_declarations(const OwnText &text, int lights) {
    const auto named = [&](const auto &row) { return text.names(row.name); };
    std::vector<std::string> lines;
    for (const LightKind &kind : light_kinds) {
        if (const std::string name = constant_of(kind); text.names(name)) {
            lines.push_back(fmt::format("const int {} = {};", name, static_cast<int>(kind.type)));
        }
    }
    if (text.names("light_count")) {
        lines.push_back(fmt::format("const int light_count = {};", lights));
    }
    if (text.names("Light") || text.names("lights")) {
        add_struct(lines, "Light", own_light_fields(),
                   [&](const FromLight &field) { return text.makes_lights || named(field); });
    }
    if (text.names("lights")) {
        lines.push_back(fmt::format("uniform Light lights[{}];", std::max(lights, 1)));
    }
    if (text.names("Material") || text.names("material")) {
        add_struct(lines, "Material", own_material_fields(), named);
    }
    if (text.names("material")) {
        lines.emplace_back("uniform Material material;");
    }
    for (const FromSubject &row : uniforms) {
        if (named(row)) {
            lines.push_back(fmt::format("uniform {} {};", row.type, row.name));
        }
    }
    if (text.loops) {
        lines.push_back(fmt::format("int own_turns = 0; // of all loops together, at most {}", most_own_turns));
        lines.push_back(fmt::format("bool own_turn() {{ return ++own_turns <= {}; }}", most_own_turns));
    }
    return lines;
}

std::vector<std::string> own_interface_comments() {
    std::vector<std::string> lines;
    std::string kinds;
    for (const LightKind &kind : light_kinds) {
        kinds += fmt::format("{}{} = {}", kinds.empty() ? "" : ", ", constant_of(kind), static_cast<int>(kind.type));
    }
    lines.push_back(comment("", fmt::format("const int {};", kinds), "Light.type"));
    add_struct_comment(lines, "Light", own_light_fields());
    lines.push_back(comment("", "const int light_count;", "how many lights are on; may be 0"));
    lines.push_back(comment("", "Light lights[light_count];", "in the order of the scene file"));
    add_struct_comment(lines, "Material", own_material_fields());
    lines.push_back(comment("", "Material material;", ""));
    for (const FromSubject &row : uniforms) {
        lines.push_back(comment("", fmt::format("{} {};", row.type, row.name), row.doc));
    }
    lines.push_back(comment("", "vec3 base();",
                            "the colour of texture, chequer and vertices here, 1 where there is none; what lighting() "
                            "returns is a + b base()"));
    return lines;
}

} // namespace sandbox
