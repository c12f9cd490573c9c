#include "teach/marking/wrong_lines.h"

#include "shading/own_files.h"

#include <string>
#include <utility>

namespace sandbox {
namespace {

using enum MarkTerm;
using Kind = ErrorKind;

// As own_answer.glsl has them.
constexpr std::string_view max_n_dot_l = "max(n_dot_l, 0.0)";
constexpr std::string_view ambient_light = "light.color * light.ambient *";
constexpr std::string_view diffuse_light = "light.color * light.diffuse *";
constexpr std::string_view specular_light = "light.color * light.specular *";
constexpr std::string_view to_light = "normalize(light.position - P)";
constexpr std::string_view fade = "1.0 / (light.constant + light.linear * d + light.quadratic * d * d)";
constexpr std::string_view mirrored = "dot(reflect(-L, N), V)";
constexpr std::string_view halved = "dot(N, normalize(L + V))";
constexpr std::string_view soft = "smoothstep(light.cos_cutoff, light.cos_inner_cutoff, c)";
constexpr std::string_view shine = "material.specular * specular";

constexpr WrongLine lines[]{
    {"ambient-missing", {ambient}, Kind::missing, "material.ambient * ambient + ", ""},
    {"ambient-doubled", {ambient}, Kind::too_bright, "material.ambient * ambient", "2.0 * material.ambient * ambient"},
    {"ambient-doubled", {ambient}, Kind::too_bright, ambient_light, "2.0 * light.color * light.ambient *"},
    {"ambient-diffuse-material", {ambient}, Kind::color, "material.ambient * ambient", "material.diffuse * ambient"},
    {"ambient-no-material", {ambient}, Kind::color, "material.ambient * ambient", "ambient"},
    {"ambient-no-color", {ambient}, Kind::color, ambient_light, "vec3(1.0) * light.ambient *"},
    {"ambient-no-intensity", {ambient}, Kind::unheeding, ambient_light, "light.color *"},
    {"ambient-scene-missing", {ambient}, Kind::missing, "vec3 ambient = scene_ambient", "vec3 ambient = vec3(0.0)"},
    {"ambient-where-lit", {ambient}, Kind::step, "ambient += ", "if (n_dot_l > 0.0) ambient += "},
    {"ambient-times-n-dot-l",
     {ambient},
     Kind::step,
     ambient_light,
     "light.color * light.ambient * max(n_dot_l, 0.0) *"},

    {"diffuse-missing", {diffuse}, Kind::missing, "material.diffuse * diffuse", "0.0 * diffuse"},
    {"no-max", {diffuse}, Kind::negative, max_n_dot_l, "n_dot_l"},
    {"abs", {diffuse}, Kind::unlit_too, max_n_dot_l, "abs(n_dot_l)"},
    {"light-reversed",
     {diffuse, specular},
     Kind::elsewhere,
     "float n_dot_l = dot(N, L)",
     "L = -L; float n_dot_l = dot(N, L)"},
    {"light-reversed", {diffuse, specular}, Kind::elsewhere, to_light, "normalize(P - light.position)"},
    {"diffuse-reversed", {diffuse}, Kind::elsewhere, max_n_dot_l, "max(-n_dot_l, 0.0)"},
    {"wrapped", {diffuse}, Kind::too_wide, max_n_dot_l, "(0.5 * n_dot_l + 0.5)"},
    {"diffuse-no-color", {diffuse}, Kind::color, diffuse_light, "vec3(1.0) * light.diffuse *"},
    {"diffuse-no-intensity", {diffuse}, Kind::unheeding, diffuse_light, "light.color *"},
    {"diffuse-no-material", {diffuse}, Kind::color, "material.diffuse * diffuse", "diffuse"},
    {"diffuse-ambient-material", {diffuse}, Kind::color, "material.diffuse * diffuse", "material.ambient * diffuse"},
    {"diffuse-doubled", {diffuse}, Kind::too_bright, "material.diffuse * diffuse", "2.0 * material.diffuse * diffuse"},
    {"divided-by-pi",
     {diffuse},
     Kind::too_dark,
     "material.diffuse * diffuse",
     "material.diffuse * diffuse / 3.14159265"},
    {"direction-not-negated", {diffuse, specular}, Kind::elsewhere, "-light.direction :", "light.direction :"},
    {"light-not-unit", {diffuse, specular}, Kind::too_bright, to_light, "(light.position - P)"},
    {"light-from-origin", {diffuse, specular}, Kind::elsewhere, to_light, "normalize(light.position)"},
    {"squared-cosine", {diffuse}, Kind::too_narrow, max_n_dot_l, "max(n_dot_l, 0.0) * max(n_dot_l, 0.0)"},

    {"reflect-sign", {specular}, Kind::elsewhere, "reflect(-L, N)", "reflect(L, N)"},
    {"reflect-swapped", {specular}, Kind::elsewhere, "reflect(-L, N)", "reflect(N, L)"},
    {"view-reversed", {specular}, Kind::elsewhere, "normalize(eye - P)", "normalize(P - eye)"},
    {"view-not-unit", {specular}, Kind::too_wide, "normalize(eye - P)", "(eye - P)"},
    {"view-from-origin", {specular}, Kind::elsewhere, "normalize(eye - P)", "normalize(eye)"},
    {"half-not-unit", {specular}, Kind::too_bright, "normalize(L + V)", "(L + V)"},
    {"half-averaged", {specular}, Kind::too_narrow, "normalize(L + V)", "((L + V) / 2.0)"},
    {"half-of-difference", {specular}, Kind::elsewhere, "normalize(L + V)", "normalize(L - V)"},
    {"not-gated",
     {specular},
     Kind::unlit_too,
     "if (n_dot_l > 0.0) { // no highlight where the light does not reach",
     "{"},
    {"specular-times-n-dot-l",
     {specular},
     Kind::too_dark,
     "pow(f, n) * fades",
     "pow(f, n) * max(n_dot_l, 0.0) * fades"},
    {"no-exponent", {specular}, Kind::too_wide, "pow(f, n)", "f"},
    {"exponent-doubled", {specular}, Kind::too_narrow, "pow(f, n)", "pow(f, 2.0 * n)"},
    {"exponent-halved", {specular}, Kind::too_wide, "pow(f, n)", "pow(f, 0.5 * n)"},
    {"exponent-four-times", {specular}, Kind::too_narrow, "pow(f, n)", "pow(f, 4.0 * n)"},
    {"exponent-quarter", {specular}, Kind::too_wide, "pow(f, n)", "pow(f, 0.25 * n)"},
    {"exponent-128", {specular}, Kind::too_narrow, "pow(f, n)", "pow(f, 128.0 * n)"},
    {"exponent-fixed", {specular}, Kind::shape, "pow(f, n)", "pow(f, 32.0)"},
    {"blinn-for-phong", {specular}, Kind::too_wide, mirrored, halved},
    {"phong-for-blinn", {specular}, Kind::too_narrow, halved, mirrored},
    {"highlight-faces-viewer", {specular}, Kind::with_camera, mirrored, "dot(N, V)"},
    {"highlight-faces-viewer", {specular}, Kind::with_camera, halved, "dot(N, V)"},
    {"specular-no-color", {specular}, Kind::color, specular_light, "vec3(1.0) * light.specular *"},
    {"specular-no-intensity", {specular}, Kind::unheeding, specular_light, "light.color *"},
    {"specular-no-material", {specular}, Kind::color, shine, "specular"},
    {"specular-diffuse-material", {specular}, Kind::color, shine, "material.diffuse * specular"},
    {"specular-missing", {specular}, Kind::missing, shine, "0.0 * specular"},

    {"attenuation-missing", {attenuation}, Kind::missing, fade, "1.0"},
    {"attenuation-inverted",
     {attenuation},
     Kind::too_bright,
     fade,
     "(light.constant + light.linear * d + light.quadratic * d * d)"},
    {"attenuation-no-quadratic", {attenuation}, Kind::too_bright, fade, "1.0 / (light.constant + light.linear * d)"},
    {"attenuation-no-linear",
     {attenuation},
     Kind::too_bright,
     fade,
     "1.0 / (light.constant + light.quadratic * d * d)"},
    {"attenuation-no-constant",
     {attenuation},
     Kind::too_bright,
     fade,
     "1.0 / (light.linear * d + light.quadratic * d * d)"},
    {"attenuation-not-squared",
     {attenuation},
     Kind::too_bright,
     fade,
     "1.0 / (light.constant + light.linear * d + light.quadratic * d)"},
    {"attenuation-distance-squared",
     {attenuation},
     Kind::too_dark,
     "float d = length(light.position - P)",
     "float d = dot(light.position - P, light.position - P)"},
    {"attenuation-inverse-square", {attenuation, diffuse, specular}, Kind::shape, fade, "1.0 / (d * d)"},
    {"attenuation-shifted",
     {attenuation},
     Kind::shape,
     fade,
     "1.0 / (light.constant + light.linear + light.quadratic * d)"},
    {"attenuation-reciprocals",
     {attenuation, diffuse, specular},
     Kind::not_finite,
     fade,
     "1.0 / light.constant + 1.0 / (light.linear * d) + 1.0 / (light.quadratic * d * d)"},
    {"attenuation-of-eye",
     {attenuation},
     Kind::with_camera,
     "float d = length(light.position - P)",
     "float d = length(eye - P)"},
    {"attenuation-of-origin",
     {attenuation},
     Kind::everywhere,
     "float d = length(light.position - P)",
     "float d = length(light.position)"},

    {"cone-missing", {cone}, Kind::missing, "if (light.type == SPOT && light.cutoff_degrees < 180.0)", "if (false)"},
    {"cone-degrees", {cone}, Kind::too_dark, soft, "(c < light.cutoff_degrees ? 0.0 : 1.0)"},
    {"cone-reversed", {cone}, Kind::elsewhere, "dot(-L, light.direction)", "dot(L, light.direction)"},
    {"cone-degrees", {cone}, Kind::missing, soft, "smoothstep(light.cutoff_degrees, light.inner_cutoff_degrees, c)"},
    {"cone-hard", {cone}, Kind::step, soft, "(c < light.cos_cutoff ? 0.0 : 1.0)"},
    {"cone-hard-inner", {cone}, Kind::step, soft, "(c < light.cos_inner_cutoff ? 0.0 : 1.0)"},
    {"cone-linear",
     {cone},
     Kind::shape,
     soft,
     "clamp((c - light.cos_cutoff) / (light.cos_inner_cutoff - light.cos_cutoff), 0.0, 1.0)"},
    {"cone-swapped", {cone}, Kind::elsewhere, soft, "smoothstep(light.cos_inner_cutoff, light.cos_cutoff, c)"},
    {"cone-degrees-as-radians",
     {cone},
     Kind::too_wide,
     soft,
     "smoothstep(cos(light.cutoff_degrees), cos(light.inner_cutoff_degrees), c)"},
    {"cone-material-exponent", {cone}, Kind::too_narrow, "pow(c, light.exponent)", "pow(c, material.shininess)"},
    {"cone-half-angle",
     {cone},
     Kind::too_narrow,
     soft,
     "smoothstep(cos(radians(0.5 * light.cutoff_degrees)), cos(radians(0.5 * light.inner_cutoff_degrees)), c)"},
    {"cone-in-degrees",
     {cone},
     Kind::shape,
     soft,
     "smoothstep(light.cutoff_degrees, light.inner_cutoff_degrees, degrees(acos(c)))"},
    {"cone-no-exponent", {cone}, Kind::too_bright, "pow(c, light.exponent)", "1.0"},
    {"cone-no-edge", {cone}, Kind::too_wide, soft, "1.0"},
    {"ambient-faded", {attenuation, cone}, Kind::too_dark, "(light.attenuate_ambient ? fades : 1.0)", "fades"},
    {"ambient-not-faded", {attenuation, cone}, Kind::too_bright, "(light.attenuate_ambient ? fades : 1.0)", "1.0"},
    {"diffuse-not-faded", {attenuation, cone}, Kind::too_bright, "max(n_dot_l, 0.0) * fades", "max(n_dot_l, 0.0)"},
    {"specular-not-faded", {attenuation, cone}, Kind::too_bright, "pow(f, n) * fades", "pow(f, n)"},

    {"normals-model-matrix",
     {normals},
     Kind::shape,
     "",
     "\nvec3 normal(vec3 n) { return normalize(mat3(model_matrix) * n); }\n"},
    {"normals-untransformed", {normals}, Kind::with_object, "", "\nvec3 normal(vec3 n) { return n; }\n"},
    {"normals-with-translation",
     {normals, diffuse, specular},
     Kind::shape,
     "",
     "\nvec3 normal(vec3 n) { return normalize((model_matrix * vec4(n, 1.0)).xyz); }\n"},
    {"normals-inverse",
     {normals},
     Kind::shape,
     "",
     "\nvec3 normal(vec3 n) { return normalize(transpose(normal_matrix) * n); }\n"},
    {"normals-transpose",
     {normals},
     Kind::shape,
     "",
     "\nvec3 normal(vec3 n) { return normalize(transpose(mat3(model_matrix)) * n); }\n"},
    {"normals-not-unit", {normals}, Kind::shape, "", "\nvec3 normal(vec3 n) { return normal_matrix * n; }\n"},
    {"n-not-unit", {normals, specular, diffuse}, Kind::too_dark, "N = normalize(N);", ""},

    {"first-light-only", {sum}, Kind::too_dark, "i < light_count", "i < 1"},
    {"last-light-only", {sum}, Kind::too_dark, "for (int i = 0;", "for (int i = light_count - 1;"},
    {"first-light-left-out", {sum}, Kind::too_dark, "for (int i = 0;", "for (int i = 1;"},
};

} // namespace

std::span<const WrongLine> wrong_lines() { return lines; }

std::optional<OwnShader> wrong_text(const WrongLine &line, const Exercise &exercise, const ShaderParts &parts) {
    std::string text = own_answer({}, exercise.target, parts);
    if (line.from.empty()) {
        text += line.to;
    } else {
        std::size_t at = text.find(line.from);
        if (at == std::string::npos) {
            return std::nullopt;
        }
        for (; at != std::string::npos; at = text.find(line.from, at + line.to.size())) {
            text.replace(at, line.from.size(), line.to);
        }
    }
    return OwnShader(std::string(line.id), std::move(text), OwnShader::Author::program);
}

} // namespace sandbox
