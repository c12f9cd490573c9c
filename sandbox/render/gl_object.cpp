#include "render/gl_object.h"

#include "image/error.h"
#include "render/gl.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

unsigned checked(unsigned id, const char *what) {
    if (id == 0) {
        throw MachineError("OpenGL gives no {} (error {:#06x})", what, glGetError());
    }
    return id;
}

template <typename Generate> unsigned generate(Generate function, const char *what) {
    unsigned id = 0;
    function(1, &id);
    return checked(id, what);
}

} // namespace

void delete_buffer(unsigned id) { glDeleteBuffers(1, &id); }
void delete_vertex_array(unsigned id) { glDeleteVertexArrays(1, &id); }
void delete_texture(unsigned id) { glDeleteTextures(1, &id); }
void delete_renderbuffer(unsigned id) { glDeleteRenderbuffers(1, &id); }
void delete_framebuffer(unsigned id) { glDeleteFramebuffers(1, &id); }
void delete_shader(unsigned id) { glDeleteShader(id); }
void delete_program(unsigned id) { glDeleteProgram(id); }
void delete_query(unsigned id) { glDeleteQueries(1, &id); }

Buffer make_buffer() { return Buffer(generate(glGenBuffers, "buffer")); }
VertexArray make_vertex_array() { return VertexArray(generate(glGenVertexArrays, "vertex array")); }
Texture make_texture() { return Texture(generate(glGenTextures, "texture")); }
Renderbuffer make_renderbuffer() { return Renderbuffer(generate(glGenRenderbuffers, "renderbuffer")); }
Framebuffer make_framebuffer() { return Framebuffer(generate(glGenFramebuffers, "framebuffer")); }
ShaderObject make_shader(unsigned stage) { return ShaderObject(checked(glCreateShader(stage), "shader")); }
ProgramObject make_program() { return ProgramObject(checked(glCreateProgram(), "program")); }
Query make_query() { return Query(generate(glGenQueries, "query")); }

} // namespace sandbox
