#include "ui/keyboard.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(Keyboard, ATapBetweenTwoFramesIsSeenOnceWithItsModifiers) {
    Keyboard keyboard;
    keyboard.press(GLFW_KEY_V, GLFW_KEY_V, GLFW_MOD_CONTROL);
    keyboard.release(GLFW_KEY_V);
    const KeysDown seen = keyboard.take(0);
    EXPECT_EQ(seen.keys, std::set<int>{GLFW_KEY_V});
    EXPECT_EQ(seen.mods, GLFW_MOD_CONTROL);
    const KeysDown after = keyboard.take(0);
    EXPECT_TRUE(after.keys.empty());
    EXPECT_EQ(after.mods, 0);
}

TEST(Keyboard, AHeldKeyIsDownUntilItsPlaceIsReleased) {
    Keyboard keyboard;
    keyboard.press(GLFW_KEY_Q, GLFW_KEY_A, 0); // on a French keyboard
    EXPECT_TRUE(keyboard.take(0).keys.contains(GLFW_KEY_A));
    EXPECT_TRUE(keyboard.take(GLFW_MOD_SHIFT).keys.contains(GLFW_KEY_A));
    keyboard.release(GLFW_KEY_Q); // whatever the layout says now
    EXPECT_TRUE(keyboard.take(0).keys.empty());
}

TEST(Keyboard, NothingIsHeldAfterTheFocusWent) {
    Keyboard keyboard;
    keyboard.press(GLFW_KEY_SPACE, GLFW_KEY_SPACE, 0);
    EXPECT_TRUE(keyboard.holds(GLFW_KEY_SPACE));
    keyboard.release_all();
    EXPECT_FALSE(keyboard.holds(GLFW_KEY_SPACE));
    EXPECT_TRUE(keyboard.tapped()); // it was pressed since the last frame
}

} // namespace
} // namespace sandbox
