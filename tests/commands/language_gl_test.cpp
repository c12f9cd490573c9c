#include "commands/script_gl.h"
#include "image/system_font.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

/// The window and captures in English and Simplified Chinese. Where no font has Chinese characters, there is a hint.
namespace sandbox {
namespace {

class LanguageGl : public ScriptGl {
  protected:
    /// In Chinese, from the first frame on.
    [[nodiscard]] ProcessResult play_chinese(const std::string &script) const {
        return play(script, {"three-point-lights", "--lang", "zh"});
    }
};

TEST_F(LanguageGl, WindowSpeaksChineseOrSaysWhatIsMissing) {
    if (!chinese_font()) {
        EXPECT_PLAYED(play_chinese("expect Status \"install fonts-noto-cjk or fonts-wqy-microhei\"\n"
                                   "expect Lights \"Lights (3)\"\n"));
        return;
    }
    EXPECT_PLAYED(
        play_chinese("expect Status 拖动\nexpect Lights 光源\nexpect A/name 逐顶点\nexpect View/differ 着色频率\n"
                     "click Technique/A/flat\nexpect A/name 逐面\n" // by the same names as in English
                     "click Language\nclick Language/English\nexpect Lights \"Lights (3)\"\n"
                     "expect A/name \"flat / phong\"\n"
                     "click Language\nclick Language/Chinese\nexpect Lights 光源\n"));
}

TEST_F(LanguageGl, SettingsKeepTheLanguage) {
    folder.write("settings.json", R"({"language": "zh"})");
    EXPECT_PLAYED(play("click Language\nclick Language/English\n", {"point-light", "--settings", "settings.json"}));
    EXPECT_EQ(nlohmann::json::parse(folder.read("settings.json"))["language"], "en");
}

/// A script's language is English, whatever the system's.
TEST_F(LanguageGl, ScriptsAreInEnglish) {
    folder.write("script.txt", "expect Lights \"Lights (1)\"\n");
    EXPECT_PLAYED(run_sandbox({"view", "point-light", "--script", "script.txt"},
                              "cd " + folder.path().string() + " && env LC_ALL=zh_CN.UTF-8"));
}

TEST_F(LanguageGl, LabelsOfCapturesAreInItAndTheSidecarSaysSo) {
    const Arguments capture{"capture", "point-light", "--labels", "--size", "320x240", "--out"};
    const auto shoot = [&](const std::string &name, const Arguments &more) {
        Arguments all = capture;
        all.push_back(folder.file(name));
        all.insert(all.end(), more.begin(), more.end());
        const ProcessResult result = run_sandbox(all);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    };
    shoot("english.png", {});
    shoot("chinese.png", {"--lang", "zh"});
    EXPECT_TRUE(nlohmann::json::parse(folder.read("chinese.png.json"))["language"] == "zh");
    EXPECT_FALSE(nlohmann::json::parse(folder.read("english.png.json")).contains("language"));
    if (chinese_font()) {
        expect_other("english.png", "chinese.png");
    } else {
        expect_same("english.png", "chinese.png"); // and a note says why
    }
    const ProcessResult again =
        run_sandbox({"capture", folder.file("chinese.png.json"), "--out", folder.file("b.png")});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    expect_same("chinese.png", "b.png");
    EXPECT_EQ(run_sandbox({"capture", "point-light", "--lang", "fr", "--out", folder.file("c.png")}).exit_code, 2);
}

/// No text is cut off, and none lies over another: every panel, tab, layout and menu, at two magnifications; stories of
/// cases and steps of lessons in a large and in a small window.
class TextsFitGl : public LanguageGl {
  protected:
    void expect_texts_fit(const Arguments &language, const std::string &scale) const {
        std::string script = "size 1280x720\nscale " + scale + "\ntexts\n";
        for (const char *panel : {"Faults", "Material", "Mesh", "\"Camera and display\""}) {
            script += std::string("click ") + panel + "\ntexts\n";
        }
        for (const char key : {'P', 'L', 'O', 'E', 'G', 'S', '2', '3', '4', '5'}) {
            script += std::string("key ") + key + "\ntexts\n";
        }
        for (const char *menu : {"Scene", "Edit", "Window", "Language"}) {
            script += std::string("click ") + menu + "\ntexts\nkey Escape\n";
        }
        script += "click Lesson\ntexts\nclick \"Famous bugs\"\ntexts\nkey Escape\nkey Escape\nkey F1\ntexts\n";
        Arguments all{"three-point-lights"};
        all.insert(all.end(), language.begin(), language.end());
        EXPECT_PLAYED(play(script, all));
    }

    void expect_stories_fit(const std::string &language) const {
        std::string cases = "key S\n", steps;
        for (const std::string size : {"size 1280x720\n", "size 800x500\n"}) {
            cases += size;
            for (const char *told : {"exponent-1e3-phong-point", "geometry-light-at-a-vertex"}) {
                cases +=
                    fmt::format("click Stability/{}\ntexts\nclick \"Stability/Run this case\"\nwait\ntexts\n", told);
            }
            steps += size + "wait\ntexts\nkey PageDown\nkey End\nwait\ntexts\nkey PageUp\n";
        }
        EXPECT_PLAYED(play(cases, {"point-light", "--lang", language}));
        for (const char *lesson : {"vertex-or-pixel", "highlight-in-the-dark"}) {
            EXPECT_PLAYED(play(steps, {"--lesson", lesson, "--lang", language}));
        }
    }
};

TEST_F(TextsFitGl, InEnglish) {
    expect_texts_fit({}, "1");
    expect_stories_fit("en");
}
TEST_F(TextsFitGl, InEnglishMagnified) { expect_texts_fit({}, "1.5"); }
TEST_F(TextsFitGl, InChinese) {
    if (!chinese_font()) {
        GTEST_SKIP() << "no font with Chinese characters is installed";
    }
    expect_texts_fit({"--lang", "zh"}, "1");
    expect_texts_fit({"--lang", "zh"}, "1.5");
    expect_stories_fit("zh");
}

} // namespace
} // namespace sandbox
