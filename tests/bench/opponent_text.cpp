#include "opponent_text.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

constexpr const char *textbook_lighting = R"(
struct PointLight {
    vec3 position;
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
    float constant;
    float linear;
    float quadratic;
};
struct Material {
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
    float shininess;
};
uniform PointLight lights[LIGHTS];
uniform Material material;
uniform vec3 eye;

vec3 light_surface(vec3 P, vec3 normal) {
    vec3 N = normalize(normal);
    vec3 V = normalize(eye - P);
    vec3 result = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 L = normalize(lights[i].position - P);
        float d = length(lights[i].position - P);
        float attenuation = 1.0 / (lights[i].constant + lights[i].linear * d + lights[i].quadratic * d * d);
        float n_dot_l = dot(N, L);
        vec3 ambient = lights[i].ambient * material.ambient;
        vec3 diffuse = lights[i].diffuse * material.diffuse * max(n_dot_l, 0.0);
        vec3 specular = vec3(0.0);
        if (n_dot_l > 0.0) {
#ifdef PHONG
            vec3 R = reflect(-L, N);
            float f = max(dot(R, V), 0.0);
#else
            vec3 H = normalize(L + V);
            float f = max(dot(N, H), 0.0);
#endif
            specular = lights[i].specular * material.specular * pow(f, material.shininess);
        }
        result += ambient + attenuation * (diffuse + specular);
    }
    return result;
}
)";

constexpr const char *vertex_inputs = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform mat3 normal_matrix;
)";
constexpr const char *per_pixel_vertex = R"(
out vec3 world_position;
out vec3 world_normal;
void main() {
    world_position = vec3(model * vec4(position, 1.0));
    world_normal = normal_matrix * normal;
    gl_Position = projection * view * vec4(world_position, 1.0);
}
)";
constexpr const char *per_pixel_fragment = R"(
in vec3 world_position;
in vec3 world_normal;
out vec4 colour;
void main() { colour = vec4(light_surface(world_position, world_normal), 1.0); }
)";
constexpr const char *per_vertex_vertex = R"(
out vec3 lit;
void main() {
    vec3 world_position = vec3(model * vec4(position, 1.0));
    lit = light_surface(world_position, normal_matrix * normal);
    gl_Position = projection * view * vec4(world_position, 1.0);
}
)";
constexpr const char *per_vertex_fragment = R"(
in vec3 lit;
out vec4 colour;
void main() { colour = vec4(lit, 1.0); }
)";
constexpr const char *constant_vertex = R"(
layout(location = 0) in vec3 position;
uniform mat4 model_view_projection;
void main() { gl_Position = model_view_projection * vec4(position, 1.0); }
)";
constexpr const char *constant_fragment = R"(
uniform vec3 constant_colour;
out vec4 colour;
void main() { colour = vec4(constant_colour, 1.0); }
)";

// Those who leave out the transform that there is none of.
constexpr const char *untransformed_inputs = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 model_view_projection;
)";
constexpr const char *untransformed_per_pixel_vertex = R"(
out vec3 world_position;
out vec3 world_normal;
void main() {
    world_position = position;
    world_normal = normal;
    gl_Position = model_view_projection * vec4(position, 1.0);
}
)";
constexpr const char *untransformed_per_vertex_vertex = R"(
out vec3 lit;
void main() {
    lit = light_surface(position, normal);
    gl_Position = model_view_projection * vec4(position, 1.0);
}
)";

std::string number(double value) { return fmt::format("{:#.9g}", value); }
std::string vector(const glm::dvec3 &v) {
    return fmt::format("vec3({}, {}, {})", number(v.x), number(v.y), number(v.z));
}
std::string attenuation(const Attenuation &a) {
    return fmt::format("1.0 / ({} + {} * d + {} * d * d)", number(a.constant), number(a.linear), number(a.quadratic));
}

/// All lights of `scene` have one attenuation and one ambient, diffuse and specular factor, and the material is white.
std::string plain_lighting(const Scene &scene) {
    const Light &any = scene.lights.at(0);
    return fmt::format(R"(
uniform vec3 light_position[LIGHTS];
uniform vec3 light_color[LIGHTS];
uniform vec3 eye;

vec3 light_surface(vec3 P, vec3 normal) {{
    vec3 N = normalize(normal);
    vec3 V = normalize(eye - P);
    vec3 result = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {{
        vec3 to_light = light_position[i] - P;
        float d = length(to_light);
        vec3 L = to_light / d;
        float a = {};
        float diffuse = max(dot(N, L), 0.0);
        float specular = diffuse > 0.0 ? pow(max(dot(N, normalize(L + V)), 0.0), {}) : 0.0;
        result += ({} + a * ({} * diffuse + {} * specular)) * light_color[i];
    }}
    return result;
}}
)",
                       attenuation(any.attenuation), number(scene.objects.at(0).material.shininess),
                       number(any.ambient), number(any.diffuse), number(any.specular));
}

/// Unrolled; the ambient light of all is one constant. The exponent is a power of two.
std::string lean_lighting(const Scene &scene) {
    std::string text = fmt::format(R"(
vec3 light_surface(vec3 P, vec3 normal) {{
    vec3 N = normal * inversesqrt(dot(normal, normal));
    vec3 to_eye = {} - P;
    vec3 V = to_eye * inversesqrt(dot(to_eye, to_eye));
    vec3 to_light, L, H;
    float d2, r, d, c, f;
)",
                                   vector(scene.camera.position));
    glm::dvec3 ambient(0);
    for (const Light &light : scene.lights) {
        ambient += light.color * light.ambient;
    }
    text += fmt::format("    vec3 sum = {};\n", vector(ambient));
    for (const Light &light : scene.lights) {
        text += fmt::format(R"(
    to_light = {} - P;
    d2 = dot(to_light, to_light);
    r = inversesqrt(d2);
    d = d2 * r;
    L = to_light * r;
    c = dot(N, L);
    H = L + V;
    f = max(dot(N, H), 0.0) * inversesqrt(dot(H, H));
)",
                            vector(light.position));
        for (double n = scene.objects.at(0).material.shininess; n > 1; n /= 2) {
            text += "    f *= f;\n";
        }
        text += fmt::format(
            "    sum += {} * (({} * max(c, 0.0) + (c > 0.0 ? {} * f : 0.0)) / ({} + {} * d + {} * d2));\n",
            vector(light.color), number(light.diffuse), number(light.specular), number(light.attenuation.constant),
            number(light.attenuation.linear), number(light.attenuation.quadratic));
    }
    return text + "    return sum;\n}\n";
}

} // namespace

OpponentText opponent_text(const Scene &scene, const Opponent::Kind &kind) {
    using Writing = Opponent::Writing;
    const std::string version = fmt::format("#version 330 core\n#define LIGHTS {}\n{}", scene.lights.size(),
                                            kind.highlight == Opponent::Highlight::phong ? "#define PHONG\n" : "");
    const bool transforms = kind.writing == Writing::textbook;
    const std::string lighting = transforms                       ? textbook_lighting
                                 : kind.writing == Writing::plain ? plain_lighting(scene)
                                                                  : lean_lighting(scene);
    const std::string inputs = version + (transforms ? vertex_inputs : untransformed_inputs);
    switch (kind.shading) {
    case Opponent::Shading::per_vertex:
        return {inputs + lighting + (transforms ? per_vertex_vertex : untransformed_per_vertex_vertex),
                version + per_vertex_fragment};
    case Opponent::Shading::per_pixel:
        return {inputs + (transforms ? per_pixel_vertex : untransformed_per_pixel_vertex),
                version + lighting + per_pixel_fragment};
    case Opponent::Shading::constant_colour:
        break;
    }
    return {version + constant_vertex, version + constant_fragment};
}

} // namespace sandbox
