#include "render/gl_program.h"

#include "image/device_limit.h"
#include "render/gl.h"
#include "render/gl_state.h"
#include "shading/uniform_room.h"

#include <fmt/format.h>

#include <vector>

namespace sandbox {
namespace {

template <typename GetParameter, typename GetLog>
std::string info_log(unsigned id, GetParameter get_parameter, GetLog get_log) {
    GLint length = 0;
    get_parameter(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    if (length > 0) {
        get_log(id, length, &length, log.data());
        log.resize(static_cast<std::size_t>(length));
    }
    return log;
}

/// Nothing is asked yet: a driver may compile several stages aside.
ShaderObject compile(GLenum stage, const StageSource &source) {
    ShaderObject shader = make_shader(stage);
    const char *text = source.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    return shader;
}

void require_compiled(const ShaderObject &shader, const StageSource &source) {
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        throw ShaderError(map_log(info_log(shader.id(), glGetShaderiv, glGetShaderInfoLog), source));
    }
}

/// Before a driver says so in its own words, or not at all.
void check_uniform_room(const ProgramSource &source) {
    const auto check = [](std::string_view name, const StageSource &stage, GLenum es_vectors, GLenum components) {
        GLint available = 0;
        glGetIntegerv(is_es() ? es_vectors : components, &available);
        const std::string refusal =
            uniform_refusal(name, uniform_vectors(stage.text), is_es() ? available : available / 4);
        if (!refusal.empty()) {
            throw DeviceLimitError(refusal);
        }
    };
    check("vertex", source.vertex, GL_MAX_VERTEX_UNIFORM_VECTORS, GL_MAX_VERTEX_UNIFORM_COMPONENTS);
    check("fragment", source.fragment, GL_MAX_FRAGMENT_UNIFORM_VECTORS, GL_MAX_FRAGMENT_UNIFORM_COMPONENTS);
}

std::map<std::string, int, std::less<>> active_uniforms(unsigned program) {
    GLint count = 0;
    GLint longest = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    glGetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    std::map<std::string, int, std::less<>> result;
    std::vector<char> name(static_cast<std::size_t>(longest) + 1);
    for (GLint i = 0; i < count; ++i) {
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), longest, nullptr, &size, &type, name.data());
        std::string text = name.data();
        if (!text.ends_with("[0]")) {
            result[text] = glGetUniformLocation(program, text.c_str());
            continue;
        }
        text.resize(text.size() - 3); // an array of basic type: one name an element
        for (GLint element = 0; element < size; ++element) {
            const std::string indexed = fmt::format("{}[{}]", text, element);
            result[indexed] = glGetUniformLocation(program, indexed.c_str());
        }
    }
    return result;
}

} // namespace

void require_es(const ProgramSource &source) {
    if (!is_es() && has_gl_extension("GL_ARB_ES3_compatibility")) {
        const ProgramSource es{in_es(source.vertex), in_es(source.fragment)};
        require_compiled(compile(GL_VERTEX_SHADER, es.vertex), es.vertex);
        require_compiled(compile(GL_FRAGMENT_SHADER, es.fragment), es.fragment);
    }
}

GlProgram::GlProgram(const ProgramSource &source) : program_(make_program()) {
    check_uniform_room(source);
    const ProgramSource given = is_es() ? ProgramSource{in_es(source.vertex), in_es(source.fragment)} : source;
    const ShaderObject vertex = compile(GL_VERTEX_SHADER, given.vertex);
    const ShaderObject fragment = compile(GL_FRAGMENT_SHADER, given.fragment);
    glAttachShader(id(), vertex.id());
    glAttachShader(id(), fragment.id());
    glLinkProgram(id());
    let_driver_catch_up();
    GLint linked = GL_FALSE;
    glGetProgramiv(id(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        require_compiled(vertex, given.vertex);
        require_compiled(fragment, given.fragment);
        throw ShaderError("link: " + info_log(id(), glGetProgramiv, glGetProgramInfoLog));
    }
    glDetachShader(id(), vertex.id());
    glDetachShader(id(), fragment.id());
    uniforms_ = active_uniforms(id());
}

int GlProgram::location(std::string_view name) const {
    const auto found = uniforms_.find(name);
    if (found == uniforms_.end()) {
        throw std::logic_error(fmt::format("no active uniform '{}'", name));
    }
    return found->second;
}

void GlProgram::set(std::string_view name, int value) const { glUniform1i(location(name), value); }
void GlProgram::set(std::string_view name, unsigned value) const { glUniform1ui(location(name), value); }
void GlProgram::set(std::string_view name, float value) const { glUniform1f(location(name), value); }
void GlProgram::set(std::string_view name, const glm::vec3 &value) const { glUniform3fv(location(name), 1, &value[0]); }
void GlProgram::set(std::string_view name, const glm::mat3 &value) const {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, &value[0][0]);
}
void GlProgram::set(std::string_view name, const glm::mat4 &value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
}

} // namespace sandbox
