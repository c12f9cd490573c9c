#include "commands/process.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

/// What a scene may take, refused in one sentence.
namespace sandbox {
namespace {

TEST(BudgetOfACommand, IsRefusedNamingTheObjectAndTheFigure) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string &scene, const Arguments &more = {}) {
        folder.write("a.json", scene);
        Arguments arguments{"reference", folder.file("a.json"), "--out", folder.file("a.png"), "--size", "8x6"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = run_sandbox(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.err;
        return result.err;
    };
    const auto sphere = [](double radius) {
        return fmt::format(R"({{"mesh": {{"shape": "sphere", "radius": {}, "rings": 2048, "segments": 2048}}}})",
                           radius);
    };
    EXPECT_EQ(refusal(R"({"objects": [)" + sphere(1) + "," + sphere(2) + "]}"),
              "shading-sandbox: objects[1]: its mesh has 8384512 triangles, after 8384512 of others; a scene's meshes "
              "may have 10000000\n");
    std::string boxes = R"({"objects": [)";
    for (int i = 0; i <= 10'000; ++i) {
        boxes += i == 0 ? R"({"mesh": {"shape": "box"}})" : R"(,{"mesh": {"shape": "box"}})";
    }
    EXPECT_EQ(refusal(boxes + "]}"),
              "shading-sandbox: " + folder.file("a.json") + ": objects: expected at most 10000 elements, got 10001\n");
    const ProcessResult samples =
        run_sandbox({"capture", "point-light", "--out", folder.file("a.png"), "--size", "5120x4096", "--samples", "2"});
    EXPECT_EQ(samples.exit_code, 2);
    EXPECT_EQ(samples.err,
              "shading-sandbox: --samples: a picture of 5120x4096 has 20.0 Mpixel; one that adds up samples "
              "may have 16\n");
    EXPECT_EQ(run_sandbox({"capture", "point-light", "--out", folder.file("a.png"), "--size", "8192x8193"}).exit_code,
              2);
}

} // namespace
} // namespace sandbox
