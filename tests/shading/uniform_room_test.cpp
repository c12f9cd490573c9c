#include "shading/uniform_room.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(UniformRoom, CountsVectorsAsGlslEsPacksThem) {
    EXPECT_EQ(uniform_vectors("in vec3 n;\nvoid main() {}\n"), 0);
    EXPECT_EQ(uniform_vectors("uniform mat4 m;\nuniform vec3 eye; // the eye's\nuniform sampler2D t;\n"), 5);
    EXPECT_EQ(uniform_vectors("uniform mat3 m;\nuniform float a, b, c;\n"), 3); // beside the three rows
    EXPECT_EQ(uniform_vectors("uniform bool a, b;\nuniform int c[3];\n"), 2);   // 5 numbers
    EXPECT_EQ(uniform_vectors("uniform vec2 a[3];\n"), 2);
}

TEST(UniformRoom, CountsStructsForEveryElement) {
    const std::string light =
        "struct Light {\n    vec3 position; // in view space\n    vec3 color;\n    float n;\n};\n";
    EXPECT_EQ(uniform_vectors(light), 0);
    EXPECT_EQ(uniform_vectors(light + "uniform Light lights[64];\n"), 128);
    EXPECT_EQ(uniform_vectors(light + "uniform Light lights[2];\nuniform float a, b, c;\n"),
              5); // 4 of the 5 numbers beside
}

TEST(UniformRoom, RefusesWithTheFiguresAndWhatToTry) {
    EXPECT_EQ(uniform_refusal("fragment", 224, 224), "");
    EXPECT_EQ(uniform_refusal("fragment", 225, 224),
              "the fragment stage needs room for 225 uniform vectors, and this device has 224: try fewer lights, or "
              "program=specialised");
}

} // namespace
} // namespace sandbox
