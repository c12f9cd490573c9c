#include "shading/own_text.h"
#include "teach/marking/exercise_read.h"
#include "teach/marking/student_file.h"
#include "tools/temporary_folder.h"
#include "ui/session/own_files.h"
#include "ui/session/session.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

const std::string grey = "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(0.5); }";

/// In a folder of its own: captures and students' files go to the current one.
class ShownExerciseTest : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::current_path(folder.path()); }
    void TearDown() override { std::filesystem::current_path(before); }

    void show() { show_exercise(session, exercise, "lambert", parts); }
    [[nodiscard]] std::string text_of_a() const { return session.document.left.own->text; }

    std::filesystem::path before = std::filesystem::current_path();
    TemporaryFolder folder;
    ShaderParts parts{Assets("shaders")};
    std::shared_ptr<const Exercise> exercise =
        std::make_shared<const Exercise>(open_exercise("lambert", Assets("assets"), words_in("en", Assets("assets"))));
    Session session{document_of("scene", {}, parse_technique("per-pixel/phong"), parse_technique("per-pixel/phong"))};
};

TEST_F(ShownExerciseTest, ShowsWhatIsAskedForBesideTheTextToBeginWith) {
    const Document opened = session.document;
    show();
    EXPECT_EQ(to_string(session.document.left), "per-pixel/own");
    EXPECT_EQ(text_of_a(), student_file(*exercise, parts));
    EXPECT_EQ(session.document.right, exercise->target);
    EXPECT_EQ(session.document.scene, exercise->shown_scene());
    EXPECT_FALSE(std::filesystem::exists(session.document.exercise->file)) << "nothing is written unasked";
    undo(session);
    EXPECT_EQ(session.document, opened);
}

TEST_F(ShownExerciseTest, AStudentsFileIsGoneOnWithAndNeverOverwritten) {
    folder.write("lambert.glsl", grey);
    show();
    EXPECT_EQ(text_of_a(), grey);
    write_student_file(*session.document.exercise, parts);
    EXPECT_EQ(folder.read("lambert.glsl"), grey);
}

TEST_F(ShownExerciseTest, AFileThatIsNotAcceptedSaysWhy) {
    folder.write("lambert.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    discard;\n}\n");
    show();
    EXPECT_EQ(text_of_a(), student_file(*exercise, parts));
    EXPECT_NE(own_failure(session, false).find("lambert.glsl:3: "), std::string::npos);
}

TEST_F(ShownExerciseTest, WhatIsSavedForTheFirstTimeIsShown) {
    show();
    OwnFiles files;
    EXPECT_FALSE(files.read_saved(session));
    write_student_file(*session.document.exercise, parts);
    EXPECT_EQ(folder.read("lambert.glsl"), student_file(*exercise, parts));
    folder.write("lambert.glsl", grey);
    EXPECT_TRUE(files.read_saved(session));
    EXPECT_EQ(text_of_a(), grey);
}

} // namespace
} // namespace sandbox
