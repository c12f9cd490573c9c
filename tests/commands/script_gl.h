#pragma once

#include "commands/gl_command_test.h"

namespace sandbox {

inline const Arguments three_lights{"three-point-lights", "--left", "per-vertex/blinn-phong", "--right",
                                    "per-pixel/blinn-phong"};

/// The window, worked by scripts: `view --script` of the built program, which needs no display.
class ScriptGl : public GlCommandTest {
  protected:
    /// Runs `script` in an own folder, so that pictures and captures lie there.
    ProcessResult play(const std::string &script, const Arguments &more = three_lights) const {
        folder.write("script.txt", script);
        Arguments all{"view", "--script", "script.txt", "--size", "1000x560", "--no-times"};
        all.insert(all.end(), more.begin(), more.end());
        return run_sandbox(all, "cd " + folder.path().string() + " && env -u DISPLAY -u WAYLAND_DISPLAY");
    }
    void expect_same(const std::string &left, const std::string &right) const {
        EXPECT_TRUE(folder.read(left) == folder.read(right)) << left << " and " << right << " differ";
    }
    void expect_other(const std::string &left, const std::string &right) const {
        EXPECT_FALSE(folder.read(left) == folder.read(right)) << left << " and " << right << " are the same";
    }
};

#define EXPECT_PLAYED(result)                                                                                          \
    do {                                                                                                               \
        const ProcessResult played = (result);                                                                         \
        EXPECT_EQ(played.exit_code, 0) << played.err << played.out;                                                    \
    } while (false)

} // namespace sandbox
