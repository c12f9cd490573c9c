#include "commands/script_gl.h"

/// Own shading in the window.
namespace sandbox {
namespace {

class ScriptOwnGl : public ScriptGl {
  protected:
    void SetUp() override {
        ScriptGl::SetUp();
        folder.write("grey.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(0.5); }\n");
        folder.write("white.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(1.0); }\n");
        folder.write("wrong.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    return nothing;\n}\n");
        folder.write("refused.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    discard;\n}\n");
    }
};

TEST_F(ScriptOwnGl, AFileIsShownBesideTheTruthOfTheOtherSidesModelAndOpeningItCanBeUndone) {
    EXPECT_PLAYED(play("shot before.png\n"
                       "drop grey.glsl\nexpect Status \"A shows\"\nwait\nexpect A/name \"per-pixel / own\"\n"
                       "expect A/error \"against the truth\"\nexpect Technique/A/file grey.glsl\nshot grey.png\n"
                       "key Ctrl+Z\nexpect A/name per-vertex\n"));
    expect_other("before.png", "grey.png");
}

TEST_F(ScriptOwnGl, TheLastGoodPictureStaysBelowAnError) {
    EXPECT_PLAYED(play("drop grey.glsl\nwait\ndrop wrong.glsl\nwait\nshot error.png\n"
                       "drop refused.glsl\nexpect Status refused.glsl:3:\nexpect Technique/A/file wrong.glsl\n"));
    EXPECT_PLAYED(play("drop white.glsl\nwait\ndrop wrong.glsl\nwait\nshot other.png\n"));
    expect_other("error.png", "other.png"); // what stands below the error
}

TEST_F(ScriptOwnGl, EitherSideMayTakeItAndTheTabsStandIt) {
    EXPECT_PLAYED(play("drop grey.glsl\nwait\nclick \"Technique/B/own\"\nwait\nexpect B/name \"per-pixel / own\"\n"
                       "click \"Technique/A/phong\"\nwait\nexpect A/name \"per-pixel / phong\"\n"
                       "key P\nhover A/picture\nwait\nexpect \"Pixel probe/B/worst\" \"not known\"\n"
                       "key L\nwait\nkey O\nwait\nkey G\nwait\nkey K\nwait\nkey F12\nwait\nkey 5\nwait\ntexts\n"));
}

TEST_F(ScriptOwnGl, IsOpenedFromTheCommandLine) {
    EXPECT_PLAYED(play("wait\nexpect A/name \"per-vertex / own\"\nexpect Technique/A/file grey.glsl\n",
                       {"point-light", "--left", "per-vertex/own", "--own-left", "grey.glsl"}));
}

} // namespace
} // namespace sandbox
