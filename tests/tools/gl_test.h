#pragma once

#include "image/error.h"
#include "render/context.h"

#include <cstdlib>
#include <glad/gl.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace sandbox {

/// What SANDBOX_TESTED_PROFILE says, "core" or "es": the same tests run on both.
inline Profile tested_profile() {
    const char *profile = std::getenv("SANDBOX_TESTED_PROFILE");
    return profile == nullptr ? default_profile : profile == std::string("es") ? Profile::es : Profile::core;
}

/// Base of the tests that draw: one headless context for the whole process. Without OpenGL 3.3 they are skipped, saying
/// why; with CI=true they fail, because nobody reads what a machine skipped.
class GlTest : public testing::Test {
  protected:
    void SetUp() override {
        if (shared().context) {
            return;
        }
        const char *ci = std::getenv("CI");
        if (ci != nullptr && std::string(ci) == "true") {
            FAIL() << shared().why_not;
        }
        GTEST_SKIP() << shared().why_not;
    }
    /// No test may leave an OpenGL error behind, whatever it looked at.
    void TearDown() override {
        if (shared().context) {
            EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        }
    }
    static const Context &context() { return *shared().context; }

  private:
    struct Shared {
        std::unique_ptr<Context> context;
        std::string why_not;
        Shared() {
            try {
                context = Context::headless(Backend::egl, tested_profile());
            } catch (const MachineError &error) {
                why_not = error.what();
            }
        }
    };
    static const Shared &shared() {
        static const Shared shared;
        return shared;
    }
};

} // namespace sandbox
