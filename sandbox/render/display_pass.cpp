#include "render/display_pass.h"

#include "render/gl.h"
#include "render/gl_state.h"
#include "shading/template.h"

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

void bind_picture(int unit, const Target &target) {
    glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    glBindTexture(GL_TEXTURE_2D, target.texture());
}

constexpr float magenta[4] = {1, 0, 1, 1};

/// One triangle that covers the whole framebuffer.
void cover(const VertexArray &empty) {
    glBindVertexArray(empty.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

GlProgram display_program(const ShaderParts &parts, Display display) {
    TemplateValues values;
    values.flags = {{"srgb", display == Display::srgb}, {"exposed", true}};
    return GlProgram({expand(parts, "display_vertex.glsl", {}), expand(parts, "display_fragment.glsl", values)});
}

} // namespace

DisplayPass::DisplayPass(const ShaderParts &parts)
    : display_{display_program(parts, Display::linear), display_program(parts, Display::srgb)},
      difference_({expand(parts, "display_vertex.glsl", {}), expand(parts, "difference_fragment.glsl", {})}),
      empty_(make_vertex_array()), finite_pixels_(make_query()) {}

unsigned DisplayPass::run(const Target &from, DisplayTexture &to, const DisplayMap &map) const {
    const PassState pass(to.framebuffer(), to.size(), DepthTest::off);
    const GlProgram &program = display_[static_cast<std::size_t>(map.curve)];
    glUseProgram(program.id());
    program.set("linear_picture", 0);
    program.set("exposure", static_cast<float>(map.exposure));
    bind_picture(0, from);
    glClearBufferfv(GL_COLOR, 0, magenta);
    if (is_es()) { // which counts no samples
        cover(empty_);
        return static_cast<unsigned>(std::ranges::count_if(from.read_color().pixels, [](const glm::vec4 &pixel) {
            return !std::isfinite(pixel.r) || !std::isfinite(pixel.g) || !std::isfinite(pixel.b);
        }));
    }
    glBeginQuery(GL_SAMPLES_PASSED, finite_pixels_.id());
    cover(empty_);
    glEndQuery(GL_SAMPLES_PASSED);
    unsigned finite = 0;
    glGetQueryObjectuiv(finite_pixels_.id(), GL_QUERY_RESULT, &finite);
    return static_cast<unsigned>(to.size().width * to.size().height) - finite;
}

void DisplayPass::run_difference(const Target &left, const Target &right, DisplayTexture &to, float gain) const {
    const PassState pass(to.framebuffer(), to.size(), DepthTest::off);
    glUseProgram(difference_.id());
    difference_.set("left_picture", 0);
    difference_.set("right_picture", 1);
    difference_.set("gain", gain);
    bind_picture(0, left);
    bind_picture(1, right);
    cover(empty_);
}

} // namespace sandbox
