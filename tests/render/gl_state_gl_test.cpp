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
        glFrontFace(GL_CW);
        glDepthFunc(GL_LEQUAL);
        throw InputError("refused");
    } catch (const InputError &) {
    }
    const GLenum enabled[] = {GL_DEPTH_TEST, GL_CULL_FACE};
    for (const GLenum capability : enabled) {
        EXPECT_FALSE(glIsEnabled(capability)) << capability;
    }
    const auto value = [](GLenum name) {
        GLint value = 0;
        glGetIntegerv(name, &value);
        return value;
    };
    EXPECT_EQ(value(GL_FRONT_FACE), GL_CCW);
    EXPECT_EQ(value(GL_DEPTH_FUNC), GL_LESS);
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
