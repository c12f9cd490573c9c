#include "ui/session/settings.h"

#include "image/error.h"
#include "tools/temporary_folder.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

class SettingsTest : public testing::Test {
  protected:
    [[nodiscard]] Settings read() {
        message.clear();
        return read_settings(folder.path() / "a" / "settings.json", message);
    }
    TemporaryFolder folder;
    std::string message;
};

TEST_F(SettingsTest, WhatIsWrittenIsRead) {
    Settings settings;
    settings.dark = settings.panels = false;
    settings.scale = 1.5;
    settings.language = "zh";
    settings.window = {1000, 700};
    settings.panel_sizes = {30, 0.5F};
    settings.recent = {"/a.json"};
    settings.lessons = {"two-sided", 3, {{"two-sided", {0, 1, 3}}, {"/mine.json", {0}}}};
    settings.exercises = {"lambert", "/mine.json"};
    write_settings(folder.path() / "a" / "settings.json", settings); // makes the folder
    EXPECT_EQ(read(), settings);
    EXPECT_EQ(message, "");
}

TEST_F(SettingsTest, AbsentOnesAreTheDefaults) {
    EXPECT_EQ(read(), Settings{});
    EXPECT_EQ(message, "");
    EXPECT_EQ(read_settings("", message), Settings{});
}

TEST_F(SettingsTest, DamagedOnesAreSetAside) {
    std::filesystem::create_directories(folder.path() / "a");
    for (const char *text : {"{\"dark\": tr", "{\"scale\": \"large\"}", "[]x", "{\"window\": [1]}",
                             R"({"lessons": {"step": "x"}})", R"({"lessons": {"seen": {"a": ["x"]}}})"}) {
        folder.write("a/settings.json", text);
        EXPECT_EQ(read(), Settings{}) << text;
        EXPECT_NE(message.find("settings.json.damaged"), std::string::npos) << text;
        EXPECT_EQ(folder.read("a/settings.json.damaged"), text);
        EXPECT_FALSE(std::filesystem::exists(folder.path() / "a" / "settings.json"));
    }
}

TEST_F(SettingsTest, NumbersOutOfRangeBecomeTheNearest) {
    std::filesystem::create_directories(folder.path() / "a");
    folder.write("a/settings.json", R"({"scale": 99, "window": [1, 99999]})");
    EXPECT_EQ(read().scale, 3);
    EXPECT_EQ(read().window, (Size{480, 16384}));
    folder.write("a/settings.json", R"({"side_ems": 1000, "bottom_share": 0.01})");
    EXPECT_EQ(read().panel_sizes, (PanelSizes{most_side_ems, least_bottom_share}));
    folder.write("a/settings.json", R"({"side_ems": 1e300, "lessons": {"step": -1, "seen": {"a": [1.5, 1e300, -7]}}})");
    EXPECT_EQ(read().panel_sizes.side_ems, most_side_ems);
    EXPECT_EQ(read().lessons, (LessonProgress{"", 0, {{"a", {0, 1, 9999}}}}));
}

TEST_F(SettingsTest, TheLastFilesComeFirstAndOnce) {
    Settings settings;
    for (int i = 0; i < 14; ++i) {
        add_recent(settings, "/scenes/" + std::to_string(i) + ".json");
    }
    add_recent(settings, "/scenes/9.json");
    EXPECT_EQ(settings.recent.size(), most_recent);
    EXPECT_EQ(settings.recent[0], "/scenes/9.json");
    EXPECT_EQ(settings.recent[1], "/scenes/13.json");
}

} // namespace
} // namespace sandbox
