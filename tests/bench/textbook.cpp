#include "textbook.h"

#include "scene/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glad/gl.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <string>

namespace sandbox {
namespace {

constexpr const char *lighting = R"(
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

GLuint compile(GLenum stage, const std::string &text) {
    const GLuint shader = glCreateShader(stage);
    const char *source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        std::string log(4096, '\0');
        glGetShaderInfoLog(shader, 4096, nullptr, log.data());
        std::fprintf(stderr, "textbook shader: %s\n", log.c_str());
        std::exit(2);
    }
    return shader;
}

GLuint link(const std::string &vertex, const std::string &fragment) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    return program;
}

GLuint build(const Scene &scene, Textbook::Shading shading, Textbook::Highlight highlight) {
    const std::string version = "#version 330 core\n#define LIGHTS " + std::to_string(scene.lights.size()) + "\n" +
                                (highlight == Textbook::Highlight::phong ? "#define PHONG\n" : "");
    switch (shading) {
    case Textbook::Shading::per_vertex:
        return link(version + vertex_inputs + lighting + per_vertex_vertex, version + per_vertex_fragment);
    case Textbook::Shading::per_pixel:
        return link(version + vertex_inputs + per_pixel_vertex, version + lighting + per_pixel_fragment);
    case Textbook::Shading::constant_colour:
        break;
    }
    return link(version + constant_vertex, version + constant_fragment);
}

GLuint make_framebuffer_of(Size size) {
    GLuint framebuffer = 0, colour = 0, depth = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenTextures(1, &colour);
    glBindTexture(GL_TEXTURE_2D, colour);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.width, size.height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour, 0);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    return framebuffer;
}

} // namespace

Textbook::Textbook(const Scene &scene, Shading shading, Highlight highlight, Size size)
    : size_(size), program_(build(scene, shading, highlight)), framebuffer_(make_framebuffer_of(size)) {
    upload_mesh(scene);
    upload_uniforms(scene);
}

void Textbook::upload_mesh(const Scene &scene) {
    const Mesh mesh = build_mesh(scene.objects.at(0).mesh);
    std::vector<glm::vec3> vertices;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        vertices.insert(vertices.end(), {glm::vec3(mesh.positions[i]), glm::vec3(mesh.normals[i])});
    }
    const auto bytes = [](const auto &list) { return static_cast<GLsizeiptr>(list.size() * sizeof(list[0])); };
    glGenVertexArrays(1, &vertex_array_);
    glBindVertexArray(vertex_array_);
    GLuint buffers[2];
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, bytes(vertices), vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(mesh.triangles), mesh.triangles.data(), GL_STATIC_DRAW);
    constexpr GLsizei stride = 2 * sizeof(glm::vec3);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void *>(sizeof(glm::vec3)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    indices_ = static_cast<int>(3 * mesh.triangles.size());
}

void Textbook::upload_uniforms(const Scene &scene) const {
    glUseProgram(program_);
    const auto at = [&](const std::string &name) { return glGetUniformLocation(program_, name.c_str()); };
    const auto set3 = [&](const std::string &name, glm::dvec3 v) {
        glUniform3fv(at(name), 1, glm::value_ptr(glm::vec3(v)));
    };
    const auto set1 = [&](const std::string &name, double v) { glUniform1f(at(name), static_cast<float>(v)); };
    const auto set4x4 = [&](const std::string &name, const glm::mat4 &m) {
        glUniformMatrix4fv(at(name), 1, GL_FALSE, glm::value_ptr(m));
    };
    const Camera &camera = scene.camera;
    const float aspect = static_cast<float>(size_.width) / static_cast<float>(size_.height);
    const glm::mat4 view = glm::lookAt(glm::vec3(camera.position), glm::vec3(camera.target), glm::vec3(camera.up));
    const glm::mat4 projection =
        glm::perspective(glm::radians(static_cast<float>(camera.fov_y_degrees)), aspect,
                         static_cast<float>(camera.near_plane), static_cast<float>(camera.far_plane));
    set4x4("model", glm::mat4(1));
    set4x4("view", view);
    set4x4("projection", projection);
    set4x4("model_view_projection", projection * view);
    glUniformMatrix3fv(at("normal_matrix"), 1, GL_FALSE, glm::value_ptr(glm::mat3(1)));
    set3("eye", camera.position);
    set3("constant_colour", {0.5, 0.5, 0.5});
    const Material &material = scene.objects.at(0).material;
    set3("material.ambient", material.ambient);
    set3("material.diffuse", material.diffuse);
    set3("material.specular", material.specular);
    set1("material.shininess", material.shininess);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light &light = scene.lights[i];
        const std::string name = "lights[" + std::to_string(i) + "].";
        set3(name + "position", light.position);
        set3(name + "ambient", light.color * light.ambient);
        set3(name + "diffuse", light.color * light.diffuse);
        set3(name + "specular", light.color * light.specular);
        set1(name + "constant", light.attenuation.constant);
        set1(name + "linear", light.attenuation.linear);
        set1(name + "quadratic", light.attenuation.quadratic);
    }
}

void Textbook::frame() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, size_.width, size_.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glUseProgram(program_);
    glBindVertexArray(vertex_array_);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    glFinish();
}

std::vector<float> Textbook::read_rgba() const {
    std::vector<float> rgba(4 * static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_FLOAT, rgba.data());
    return rgba;
}

std::vector<unsigned char> Textbook::read_bytes() const {
    const auto rgba = read_rgba();
    const auto width = static_cast<std::size_t>(size_.width), height = static_cast<std::size_t>(size_.height);
    std::vector<unsigned char> bytes;
    bytes.reserve(3 * width * height);
    for (std::size_t y = height; y-- > 0;) {
        for (std::size_t x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = std::clamp(rgba[4 * (y * width + x) + c], 0.0F, 1.0F);
                bytes.push_back(static_cast<unsigned char>(value * 255.0F + 0.5F));
            }
        }
    }
    return bytes;
}

Scene three_lights_on_a_sphere() {
    Scene scene;
    const auto add = [&](glm::dvec3 color, glm::dvec3 position) {
        Light light;
        light.color = color;
        light.position = position;
        light.ambient = 0.2;
        light.diffuse = 0.8;
        light.specular = 0.8;
        light.attenuation = {.constant = 0.2, .linear = 0.1, .quadratic = 0.1};
        scene.lights.push_back(light);
    };
    add({0.8, 0, 0}, {0, 0, 3});
    add({0, 0.8, 0}, {-4, 0, -1.5});
    add({0.8, 0.8, 0.8}, {0, 6, 3});
    Object ball;
    ball.name = "ball";
    ball.mesh = SphereShape{.radius = 1, .rings = 64, .segments = 128};
    scene.objects.push_back(ball);
    return scene;
}

Scene one_directional_light() {
    Scene scene = three_lights_on_a_sphere();
    Light light;
    light.type = LightType::directional;
    light.direction = {0, -1, -1};
    scene.lights = {light};
    return scene;
}

} // namespace sandbox
