#include "commands/script_gl.h"

/// The Exercise tab.
namespace sandbox {
namespace {

class ExercisesGl : public ScriptGl {
  protected:
    /// A student's text, by what it returns for diffuse light.
    void write_lambert(const std::string &cosine) const {
        folder.write("lambert.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n"
                                     "    vec3 light = material.ambient * scene_ambient;\n"
                                     "    for (int i = 0; i < light_count; ++i) {\n"
                                     "        vec3 L = lights[i].type == DIRECTIONAL ? -lights[i].direction\n"
                                     "            : normalize(lights[i].position - P);\n"
                                     "        float c = " +
                                         cosine +
                                         ";\n"
                                         "        light += lights[i].color * (material.ambient * lights[i].ambient\n"
                                         "            + material.diffuse * lights[i].diffuse * c);\n"
                                         "    }\n    return base() * light + material.emission;\n}\n");
    }
    const Arguments lambert{"--exercise", "lambert"};
};

TEST_F(ExercisesGl, ATermThatIsWrongGetsItsHint) {
    write_lambert("abs(dot(normalize(N), L))");
    EXPECT_PLAYED(play("wait\nexpect Exercise/ambient \"ambient: 2 of 2: right\"\n"
                       "expect Exercise/diffuse \"wrong in the scene\"\ntexts\n"
                       "size 700x500\ntexts\n",
                       lambert));
}

TEST_F(ExercisesGl, ASolvedExerciseIsKept) {
    write_lambert("max(dot(normalize(N), L), 0.0)");
    const Arguments kept{"--exercise", "lambert", "--settings", "settings.json"};
    EXPECT_PLAYED(play(
        "wait\nexpect Exercise/points \"8 of 8 points\"\nexpect Exercise/error \"no error\"\nexpect Status Solved\n",
        kept));
    EXPECT_PLAYED(play("key H\nwait\nexpect Exercise/lambert solved\n", {"studio", "--settings", "settings.json"}));
}

TEST_F(ExercisesGl, WhoBeginsSeesNoFileAndGetsOne) {
    EXPECT_PLAYED(play("key H\nclick Exercise/phong\nwait\nexpect Status \"Exercise:\"\nclick Exercise/Begin\nwait\n"
                       "expect Exercise/file phong.glsl\n"));
    EXPECT_NE(folder.read("phong.glsl").find("vec3 lighting(vec3 P, vec3 N, vec3 eye)"), std::string::npos);
}

TEST_F(ExercisesGl, WhatCannotBeDrawnIsSaid) {
    folder.write("lambert.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    return nothing;\n}\n");
    EXPECT_PLAYED(play("wait\nexpect Exercise/refused lambert.glsl:3\n", lambert));
}

TEST_F(ExercisesGl, ATeachersOwnIsOpenedByItsPath) {
    ASSERT_EQ(run_sandbox({"mark", "lambert", "--student", folder.file("copy")}).exit_code, 0);
    EXPECT_PLAYED(play("drop copy/lambert.json\nwait\nexpect Status \"Exercise:\"\nexpect B/name lambert\n"));
}

} // namespace
} // namespace sandbox
