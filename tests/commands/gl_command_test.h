#pragma once

#include "commands/process.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <string>

namespace sandbox {

/// Base of the tests of commands that draw. They are skipped where the program finds no OpenGL 3.3; with CI=true they
/// fail, because nobody reads what a machine skipped.
class GlCommandTest : public testing::Test {
  protected:
    void SetUp() override {
        const ProcessResult probe = run_sandbox({"time", "point-light", "--frames", "1", "--size", "8x8"});
        const char *ci = std::getenv("CI");
        if (probe.exit_code == 3 && !(ci != nullptr && std::string(ci) == "true")) {
            GTEST_SKIP() << probe.err;
        }
        ASSERT_EQ(probe.exit_code, 0) << probe.err;
    }
    TemporaryFolder folder;
};

} // namespace sandbox
