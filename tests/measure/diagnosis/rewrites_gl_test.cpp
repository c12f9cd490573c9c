#include "render/renderer.h"
#include "tools/gl_test.h"
#include "tools/own_rewrites.h"

/// Own shading that is right is never accused, however it is written: a part of it (tools/diagnosis/confusion.cpp has
/// more).
namespace sandbox {
namespace {

class Rewrites : public GlTest {
  protected:
    Renderer renderer{Assets("assets"), ShaderParts(Assets("shaders"))};
    DiagnosisDraw draw = diagnosis_drawn_by(renderer);
};

TEST_F(Rewrites, AreRight) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const OwnRewrite rewrite = own_rewrite(seed);
        const Diagnosis diagnosis = diagnosis_of(rewrite, draw, {160, 120});
        EXPECT_FALSE(is_accused(diagnosis, rewrite))
            << seed << " " << rewrite.scene_name << " " << to_string(rewrite.truth) << ": "
            << to_string(diagnosis.technique) << ", " << diagnosis.residual.largest << " levels, "
            << diagnosis.residual.over << " pixels\n"
            << rewrite.text;
    }
}

/// What is right but for one word is not.
TEST_F(Rewrites, WithAWordWrongAreNotRight) {
    std::size_t broken = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        OwnRewrite rewrite = own_rewrite(seed);
        const auto word = rewrite.text.rfind("material.diffuse");
        if (word != std::string::npos) {
            rewrite.text.replace(word, 16, "(0.9 * material.diffuse)");
            EXPECT_NE(diagnosis_of(rewrite, draw, {160, 120}).verdict, Verdict::right) << seed << rewrite.text;
            ++broken;
        }
    }
    EXPECT_GT(broken, 8U);
}

} // namespace
} // namespace sandbox
