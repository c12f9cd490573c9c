#include "scene/read_json.h"
#include "scene/scene_setting.h"
#include "teach/files/taught_file.h"
#include "tools/error_of.h"
#include "tools/json_readers.h"
#include "tools/temporary_folder.h"
#include "ui/session/settings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

/// Every reader of JSON is handed what overflows a stack, never ends or fills the memory of one that is not bounded.
namespace sandbox {
namespace {

/// Of a text that begins as a sidecar does, which some readers look for.
std::string within(const std::string &value) { return R"({"scene": {}, "techniques": [], "rows": )" + value + "}"; }

std::string repeated(std::string_view text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

TEST(EveryJson, IsBoundedInDepthCountAndSize) {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {within(repeated("[", 100000) + repeated("]", 100000)), "a.json: nested deeper than 64 levels"},
        {within(repeated(R"({"a":)", 100000) + "0" + repeated("}", 100000)), "a.json: nested deeper than 64 levels"},
        {within("[" + repeated("{},", most_json_values) + "{}]"), "a.json: expected at most 1000000 values, got more"},
        {within(R"({"b": 1, "b": 2})"), "a.json: rows.b: this key is given twice"},
        {within("[") + std::string(largest_json, ' '), "a.json: the file is larger than 16 MiB"}};
    for (const JsonReader &reader : json_readers()) {
        for (const auto &[text, said] : wrong) {
            EXPECT_EQ(error_of([&, &hostile = text] { reader.read(hostile); }), said) << reader.name;
        }
    }
}

TEST(EveryJson, RefusesManyOfAKindInAFewWords) {
    std::string keys, views;
    for (int i = 0; i < 100000; ++i) {
        keys += fmt::format("{}\"k{}\":0", i > 0 ? "," : "", i);
        views += fmt::format("{}{{\"name\":\"{}\"}}", i > 0 ? "," : "", i);
    }
    const std::string texts[] = {"{" + keys + "}",
                                 within("{" + keys + "}"),
                                 "[" + repeated("{},", 400000) + "{}]",
                                 "{\"views\":[" + views + "]}",
                                 within("{\"k\":\"" + std::string(1000000, 'k') + "\"}"),
                                 "{\"" + std::string(1000000, 'k') + "\":0}"};
    for (const JsonReader &reader : json_readers()) {
        for (const std::string &text : texts) {
            EXPECT_LT(error_of([&] { reader.read(text); }).size(), 1000U) << reader.name << text.substr(0, 60);
        }
    }
}

TEST(EveryJson, FilesThatAreNoneOfTheirKindAreToldApart) {
    const TemporaryFolder folder;
    folder.write("deep.json", repeated("[", 100000) + repeated("]", 100000));
    EXPECT_EQ(taught_file(folder.file("deep.json")), TaughtFile::none);
    std::string message;
    EXPECT_EQ(read_settings(folder.file("deep.json"), message), Settings{});
    EXPECT_NE(message.find("deep.json.damaged"), std::string::npos) << message;
}

TEST(EveryJson, SettingsOnTheCommandLineAre) {
    EXPECT_EQ(error_of([] { with_setting({}, "background=" + repeated("[", 100000)); }),
              "--set background: nested deeper than 64 levels");
}

} // namespace
} // namespace sandbox
