#include "render/segment_pass.h"

#include "render/gl.h"

#include <cstddef>
#include <utility>

namespace sandbox {

SegmentPass::SegmentPass() : array_(make_vertex_array()), buffer_(make_buffer()) {
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    for (const auto &[location, offset] :
         {std::pair(0U, offsetof(Segment, from)), std::pair(1U, offsetof(Segment, to))}) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Segment),
                              reinterpret_cast<const void *>(offset)); // NOLINT: an offset, as OpenGL takes it
        glVertexAttribDivisor(location, 1);
    }
    glBindVertexArray(0);
}

void SegmentPass::draw(const GlProgram &program, const std::vector<Segment> &segments, float radius,
                       const Target &target) {
    program.set("radius", radius);
    program.set("width", static_cast<float>(target.size().width));
    program.set("height", static_cast<float>(target.size().height));
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE); // the picture's alpha stays
    glDepthMask(GL_FALSE);
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(segments.size() * sizeof(Segment)), segments.data(),
                 GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(segments.size()));
    glBindVertexArray(0);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

} // namespace sandbox
