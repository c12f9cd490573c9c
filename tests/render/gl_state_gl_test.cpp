#include "render/gl_state.h"

#include "render/target.h"
#include "tools/gl_test.h"

#include <glad/gl.h>

namespace sandbox {
namespace {

class GlState : public GlTest {};

TEST_F(GlState, IsRestoredAtTheEndOfAPassEvenIfSomethingThrows) {
    const Target target({4, 4});
    try {
        const PassState pass(target.framebuffer(), target.size(), DepthTest::on);
        EXPECT_TRUE(glIsEnabled(GL_DEPTH_TEST));
        glEnable(GL_CULL_FACE);
        glEnable(GL_DEPTH_CLAMP);
        glEnable(GL_POLYGON_OFFSET_LINE);
        glFrontFace(GL_CW);
        glDepthFunc(GL_LEQUAL);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        throw InputError("refused");
    } catch (const InputError &) {
    }
    const GLenum enabled[] = {GL_DEPTH_TEST, GL_CULL_FACE, GL_DEPTH_CLAMP, GL_POLYGON_OFFSET_LINE};
    for (const GLenum capability : enabled) {
        EXPECT_FALSE(glIsEnabled(capability)) << capability;
    }
    const auto value = [](GLenum name) {
        GLint values[2] = {}; // GL_POLYGON_MODE has two
        glGetIntegerv(name, values);
        return values[0];
    };
    EXPECT_EQ(value(GL_FRONT_FACE), GL_CCW);
    EXPECT_EQ(value(GL_DEPTH_FUNC), GL_LESS);
    EXPECT_EQ(value(GL_POLYGON_MODE), GL_FILL);
}

TEST_F(GlState, AnErrorIsReportedWithWhatWasTried) {
    check_gl("start"); // nothing is wrong yet
    glEnable(GL_TRIANGLES);
    try {
        check_gl("store a picture");
        FAIL();
    } catch (const MachineError &error) {
        EXPECT_STREQ(error.what(), "OpenGL cannot store a picture: error 0x0500"); // GL_INVALID_ENUM
    }
}

} // namespace
} // namespace sandbox
