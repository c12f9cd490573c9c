#include "opponent.h"

#include "opponent_text.h"

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
        std::fprintf(stderr, "opponent's shader: %s\n", log.c_str());
        std::exit(2);
    }
    return shader;
}

GLuint link(const OpponentText &text) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, text.vertex));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, text.fragment));
    glLinkProgram(program);
    return program;
}

GLuint make_framebuffer_of(Size size, Opponent::Pixels pixels) {
    const bool bytes = pixels == Opponent::Pixels::bytes;
    GLuint framebuffer = 0, colour = 0, depth = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenTextures(1, &colour);
    glBindTexture(GL_TEXTURE_2D, colour);
    glTexImage2D(GL_TEXTURE_2D, 0, bytes ? GL_RGBA8 : GL_RGBA32F, size.width, size.height, 0, GL_RGBA,
                 bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour, 0);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, bytes ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT32F, size.width,
                          size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    return framebuffer;
}

} // namespace

Opponent::Opponent(const Scene &scene, const Kind &kind, Size size)
    : size_(size), program_(link(opponent_text(scene, kind))), framebuffer_(make_framebuffer_of(size, kind.pixels)) {
    upload_mesh(scene);
    upload_uniforms(scene);
}

void Opponent::upload_mesh(const Scene &scene) {
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

void Opponent::upload_uniforms(const Scene &scene) const {
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
        const std::string index = "[" + std::to_string(i) + "]";
        set3("light_position" + index, light.position);
        set3("light_color" + index, light.color);
    }
}

void Opponent::frame() const {
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

std::vector<float> Opponent::read_rgba() const {
    std::vector<float> rgba(4 * static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_FLOAT, rgba.data());
    return rgba;
}

std::vector<unsigned char> Opponent::read_bytes() const {
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
