#include "image/error.h"
#include "tools/temporary_folder.h"
#include "ui/session/written_files.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace sandbox {
namespace {

TEST(NewFolder, NumbersThemAndOverwritesNothing) {
    const TemporaryFolder folder;
    EXPECT_EQ(new_folder(folder.path(), "ball-report"), folder.path() / "ball-report-001");
    folder.write("ball-report-002", "a file in the way");
    EXPECT_EQ(new_folder(folder.path(), "ball-report"), folder.path() / "ball-report-003");
    EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "ball-report-003"));
}

TEST(NewFolder, NamesOfScenesMayBeAnything) {
    const TemporaryFolder folder;
    EXPECT_EQ(new_folder(folder.path(), "a/b c"), folder.path() / "a-b-c-001");
}

TEST(NewFolder, SaysWhatCannotBeMade) {
    const TemporaryFolder folder;
    folder.write("file", "");
    EXPECT_THROW(new_folder(folder.path() / "file", "x"), InputError);
    EXPECT_THROW(new_folder(folder.path() / "missing", "x"), InputError);
}

} // namespace
} // namespace sandbox
