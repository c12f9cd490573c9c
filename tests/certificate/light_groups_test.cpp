#include "certificate/light_groups.h"

#include <gtest/gtest.h>

namespace sandbox::certificate {
namespace {

TEST(LightGroups, AreDividedByTheLightThatSavesMost) {
    const AreaOfLights areas{{0b011, 6}, {0b100, 3}, {0b101, 1}};
    // All in one: 10 * 3. By light 1 (0b010): 4 * 2 + 6 * 2 saves 10; by light 0: 3 + 7 * 3 saves 6; by light 2: 6 * 2
    // + 4 * 2 saves 10, too.
    const LightGroups two = group_by_lights(areas, 0, 2);
    ASSERT_EQ(two.lights.size(), 2U);
    EXPECT_EQ(two.lights[two.group_of.at(0b011)], 0b011U);
    EXPECT_EQ(two.lights[two.group_of.at(0b100)], 0b101U);
    EXPECT_EQ(two.group_of.at(0b100), two.group_of.at(0b101));
    // Then 4 * 2 becomes 3 + 1 * 2.
    const LightGroups three = group_by_lights(areas, 0, 8);
    ASSERT_EQ(three.lights.size(), 3U);
    EXPECT_EQ(three.lights[three.group_of.at(0b100)], 0b100U);
    EXPECT_EQ(group_by_lights(areas, 3, 8).lights.size(), 2U) << "3 is not more than 3";
    EXPECT_EQ(group_by_lights(areas, 10, 8).lights, std::vector<LightSet>{0b111});
}

TEST(LightGroups, OfNothingAreOneWithoutLights) {
    EXPECT_EQ(group_by_lights({}, 0, 8).lights, std::vector<LightSet>{0});
    const LightGroups dark = group_by_lights({{0, 5}, {0b1, 5}}, 0, 8);
    ASSERT_EQ(dark.lights.size(), 2U);
    EXPECT_EQ(dark.lights[dark.group_of.at(0)], 0U);
}

} // namespace
} // namespace sandbox::certificate
