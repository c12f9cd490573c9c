#pragma once

#include <utility>

namespace sandbox {

/// Owns one OpenGL name; 0 is none. Move only. Deleted in the context it was made in.
template <void (*Delete)(unsigned)> class GlObject {
  public:
    GlObject() = default;
    explicit GlObject(unsigned id) : id_(id) {}
    ~GlObject() { reset(); }
    GlObject(GlObject &&other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject &operator=(GlObject &&other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, 0);
        }
        return *this;
    }
    GlObject(const GlObject &) = delete;
    GlObject &operator=(const GlObject &) = delete;
    [[nodiscard]] unsigned id() const { return id_; }

  private:
    void reset() {
        if (id_ != 0) {
            Delete(id_);
        }
        id_ = 0;
    }
    unsigned id_ = 0;
};

void delete_buffer(unsigned id);
void delete_vertex_array(unsigned id);
void delete_texture(unsigned id);
void delete_renderbuffer(unsigned id);
void delete_framebuffer(unsigned id);
void delete_shader(unsigned id);
void delete_program(unsigned id);
void delete_query(unsigned id);

using Buffer = GlObject<delete_buffer>;
using VertexArray = GlObject<delete_vertex_array>;
using Texture = GlObject<delete_texture>;
using Renderbuffer = GlObject<delete_renderbuffer>;
using Framebuffer = GlObject<delete_framebuffer>;
using ShaderObject = GlObject<delete_shader>;
using ProgramObject = GlObject<delete_program>;
using Query = GlObject<delete_query>;

/// A new name of each kind; throws MachineError if the driver gives none.
Buffer make_buffer();
VertexArray make_vertex_array();
Texture make_texture();
Renderbuffer make_renderbuffer();
Framebuffer make_framebuffer();
ShaderObject make_shader(unsigned stage);
ProgramObject make_program();
Query make_query();

} // namespace sandbox
