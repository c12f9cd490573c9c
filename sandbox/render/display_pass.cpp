#include "render/display_pass.h"

#include <glad/gl.h>

namespace sandbox {
namespace {

void bind_picture(int unit, const Target &target) {
    glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    glBindTexture(GL_TEXTURE_2D, target.texture());
}

void cover(const DisplayTexture &to, const VertexArray &empty) {
    glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer());
    glViewport(0, 0, to.size().width, to.size().height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(empty.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace

DisplayPass::DisplayPass(const ShaderParts &parts)
    : display_({whole_part(parts, "display_vertex.glsl"), whole_part(parts, "display_fragment.glsl")}),
      difference_({whole_part(parts, "display_vertex.glsl"), whole_part(parts, "difference_fragment.glsl")}),
      empty_(make_vertex_array()) {}

void DisplayPass::run(const Target &from, DisplayTexture &to, Display display, float exposure) const {
    glUseProgram(display_.id());
    display_.set("linear_picture", 0);
    display_.set("exposure", exposure);
    display_.set("srgb", display == Display::srgb ? 1 : 0);
    bind_picture(0, from);
    cover(to, empty_);
}

void DisplayPass::run_difference(const Target &left, const Target &right, DisplayTexture &to, float gain) const {
    glUseProgram(difference_.id());
    difference_.set("left_picture", 0);
    difference_.set("right_picture", 1);
    difference_.set("gain", gain);
    bind_picture(0, left);
    bind_picture(1, right);
    cover(to, empty_);
}

} // namespace sandbox
