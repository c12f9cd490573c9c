#include "shading/own_text.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"
#include "ui/session/edits.h"
#include "ui/session/own_files.h"
#include "ui/session/session.h"

#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

const std::string grey = "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(0.5); }";
const std::string white = "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(1.0); }";

class OwnFilesTest : public testing::Test {
  protected:
    Session session{
        document_of("scene", {}, parse_technique("per-vertex/phong"), parse_technique("per-vertex/lambert"))};
    TemporaryFolder folder;
    OwnFiles files;

    /// As an editor saves: the time moves on, even within the file system's own tick.
    void save(const std::string &text) {
        const auto before = std::filesystem::last_write_time(folder.file("a.glsl"));
        folder.write("a.glsl", text);
        std::filesystem::last_write_time(folder.file("a.glsl"), before + std::chrono::seconds(1));
    }
    void open(const std::string &text) {
        folder.write("a.glsl", text);
        open_own(session, folder.file("a.glsl"));
        files.read_saved(session);
    }
    [[nodiscard]] std::string shown() const { return session.document.left.own->text; }
};

TEST_F(OwnFilesTest, AShowsWhatIsOpenedAndUndoTakesItBack) {
    const Document before = session.document;
    open(grey);
    EXPECT_EQ(to_string(session.document.left), "per-pixel/own");
    EXPECT_EQ(shown(), grey);
    EXPECT_EQ(session.document.right, before.right);
    undo(session);
    EXPECT_EQ(session.document, before);
}

TEST_F(OwnFilesTest, AFileThatIsNotAcceptedChangesNothing) {
    const Document before = session.document;
    folder.write("a.glsl", "vec3 lighting();");
    EXPECT_NE(error_of([&] { open_own(session, folder.file("a.glsl")); }), "no error");
    EXPECT_NE(error_of([&] { open_own(session, folder.file("absent.glsl")); }), "no error");
    EXPECT_EQ(session.document, before);
    EXPECT_FALSE(session.history.can_undo());
}

TEST_F(OwnFilesTest, ASavedFileIsShownAndCanBeUndone) {
    open(grey);
    EXPECT_FALSE(files.read_saved(session));
    save(white);
    EXPECT_TRUE(files.read_saved(session));
    EXPECT_EQ(shown(), white);
    undo(session);
    EXPECT_EQ(shown(), grey);
    EXPECT_FALSE(files.read_saved(session)) << "what was undone stays so until the file is saved again";
}

TEST_F(OwnFilesTest, TheLastGoodTextStaysWhereTheSavedOneIsNotAccepted) {
    open(grey);
    save("vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n    discard;\n}");
    EXPECT_TRUE(files.read_saved(session));
    EXPECT_EQ(shown(), grey);
    EXPECT_NE(own_failure(session, false).find("a.glsl:3: "), std::string::npos) << own_failure(session, false);
    EXPECT_EQ(own_failure(session, true), "") << "B shows no own shading";
    save(white);
    files.read_saved(session);
    EXPECT_EQ(own_failure(session, false), "");
    EXPECT_EQ(shown(), white);
}

TEST_F(OwnFilesTest, AnAbsentFileIsWaitedFor) {
    open(grey);
    std::filesystem::remove(folder.file("a.glsl"));
    EXPECT_FALSE(files.read_saved(session));
    EXPECT_EQ(own_failure(session, false), "");
}

TEST_F(OwnFilesTest, TheOtherSideMayTakeTheTextAndAnotherModelLetsItGo) {
    open(grey);
    EXPECT_EQ(own_of(session, true)->text, grey);
    set_key(session.document.left, model_key, static_cast<int>(Model::phong));
    EXPECT_FALSE(session.document.left.own);
    EXPECT_EQ(own_of(session, false)->text, grey) << "the last one opened";
}

} // namespace
} // namespace sandbox
