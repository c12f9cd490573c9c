#pragma once

#include "render/gl_object.h"
#include "render/gl_program.h"
#include "render/target.h"

#include <glm/vec3.hpp>
#include <vector>

namespace sandbox {

/// A line as a program of segment_vertex.glsl is given it; from == to: a dot.
struct Segment {
    glm::vec3 from, to;
};

/// Draws lines and dots of any width over what a target shows, hidden by its depth, which stays as it is.
class SegmentPass {
  public:
    SegmentPass();
    /// `program`, in use, has all uniforms but those of this: the radius in pixels and the picture's size.
    void draw(const GlProgram &program, const std::vector<Segment> &segments, float radius, const Target &target);

  private:
    VertexArray array_;
    Buffer buffer_;
};

} // namespace sandbox
