#include "image/file_io.h"
#include "image/write_files.h"
#include "image/write_guard.h"
#include "tools/error_of.h"
#include "tools/temporary_folder.h"

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <thread>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

TEST(WriteFile, ReplacesTheWholeFileAndLeavesNoOther) {
    const TemporaryFolder folder;
    write_file(folder.path() / "a.txt", "the first, longer text");
    write_file(folder.path() / "a.txt", std::string("b\0c", 3));
    EXPECT_EQ(read_file(folder.path() / "a.txt"), std::string("b\0c", 3));
    EXPECT_EQ(folder.names().size(), 1U);
}

TEST(WriteFile, NamesTheFileThatItCannotWrite) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "missing" / "a.txt";
    EXPECT_EQ(error_of([&] { write_file(path, "x"); }),
              path.string() + ": cannot write the file (No such file or directory)");
    EXPECT_NE(error_of([&] { write_file(folder.path(), "x"); }), "no error"); // a folder
    EXPECT_EQ(folder.names().size(), 0U);
}

TEST(WriteFile, WritesDevicesInPlaceAndThroughLinks) {
    write_file("/dev/null", "x");
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
    const TemporaryFolder folder;
    write_file(folder.path() / "a.txt", "x");
    fs::create_symlink(folder.path() / "a.txt", folder.path() / "link.txt");
    write_file(folder.path() / "link.txt", "y");
    EXPECT_EQ(read_file(folder.path() / "a.txt"), "y");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
}

TEST(WriteFiles, PutsAllInPlace) {
    const TemporaryFolder folder;
    folder.write("a", "old");
    write_files(std::vector<OutputFile>{{folder.file("a"), "new a"}, {folder.file("b"), "new b"}});
    EXPECT_EQ(folder.read("a"), "new a");
    EXPECT_EQ(folder.read("b"), "new b");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "b"}));
    write_files(std::vector<OutputFile>{{folder.file("a"), "1"}, {folder.file("a"), "2"}}); // --json and --out, say
    EXPECT_EQ(folder.read("a"), "2");
    EXPECT_EQ(folder.names().size(), 2U);
}

TEST(WriteFiles, ChangesNothingWhereOneCannotBeWritten) {
    const TemporaryFolder folder;
    folder.write("a", "old");
    fs::create_directory(folder.path() / "c");
    const std::vector<OutputFile> files{
        {folder.file("a"), "new"}, {folder.file("b"), "new"}, {folder.file("c"), "new"}};
    EXPECT_EQ(error_of([&] { write_files(files); }), folder.file("c") + ": cannot write the file (Is a directory)");
    EXPECT_EQ(folder.read("a"), "old");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "c"}));
}

TEST(WriteFiles, TakesBackWhatIsInPlaceWhereARenameFails) {
    const TemporaryFolder folder;
    folder.write("a", "old");
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    // The pipe is written when all the others are staged, and only when somebody reads it.
    std::thread reader([&] {
        while (folder.names().size() < 5) { // a, its new form, those of b and c, the pipe
            std::this_thread::yield();
        }
        for (const std::string &name : folder.names()) {
            if (name.starts_with("c")) {
                fs::remove(folder.path() / name);
            }
        }
        EXPECT_EQ(folder.read("pipe"), "x");
    });
    const std::vector<OutputFile> files{
        {folder.file("a"), "new"}, {folder.file("b"), "new"}, {folder.file("c"), "new"}, {pipe, "x"}};
    EXPECT_EQ(error_of([&] { write_files(files); }),
              folder.file("c") + ": cannot write the file (No such file or directory)");
    reader.join();
    EXPECT_EQ(folder.read("a"), "old");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "pipe"}));
}

TEST(WriteFiles, ReplacesALinkThatLeadsNowhere) {
    const TemporaryFolder folder;
    fs::create_symlink("ring", folder.path() / "ring");
    write_file(folder.path() / "ring", "x");
    EXPECT_EQ(folder.read("ring"), "x");
    EXPECT_EQ(folder.names().size(), 1U);
}

TEST(WriteGuard, LetsAWriteEndFirst) {
    const auto write_and_stop = [] {
        std::signal(SIGINT, [](int) { end_between_writes(); });
        {
            const WriteGuard guard;
            std::raise(SIGINT);
            std::fputs("still writing", stderr);
        }
        std::abort();
    };
    EXPECT_EXIT(write_and_stop(), testing::ExitedWithCode(130), "still writing");
    EXPECT_EXIT(end_between_writes(3), testing::ExitedWithCode(3), "");
}

TEST(CheckWritable, SaysBeforehandWhatWritingWouldSay) {
    const TemporaryFolder folder;
    folder.write("a", "old");
    check_writable(folder.path() / "a");
    check_writable(folder.path() / "b");
    check_writable("/dev/null");
    EXPECT_EQ(error_of([&] { check_writable(folder.path()); }),
              folder.path().string() + ": cannot write the file (Is a directory)");
    EXPECT_EQ(error_of([&] { check_writable(folder.path() / "a" / "b"); }),
              folder.file("a/b") + ": cannot write the file (Not a directory)");
    EXPECT_EQ(error_of([&] { check_writable("/dev/full/b"); }), "/dev/full/b: cannot write the file (Not a directory)");
    EXPECT_EQ(folder.read("a"), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
}

TEST(ReadFile, NamesTheFileThatItCannotRead) {
    EXPECT_EQ(error_of([] { read_file("/no/such.txt"); }),
              "/no/such.txt: cannot read the file (No such file or directory)");
    EXPECT_EQ(error_of([] { read_file("/tmp"); }), "/tmp: cannot read the file (Is a directory)");
}

TEST(ReadFile, ReadsRegularFilesAlone) {
    const TemporaryFolder folder;
    const fs::path pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(error_of([&] { read_file(pipe); }), pipe.string() + ": expected a regular file, got a pipe");
    EXPECT_EQ(error_of([] { read_file("/dev/zero"); }), "/dev/zero: expected a regular file, got a device");
    write_file(folder.path() / "a.txt", "text");
    fs::create_symlink(folder.path() / "a.txt", folder.path() / "link.txt");
    EXPECT_EQ(read_file(folder.path() / "link.txt"), "text");
    EXPECT_FALSE(read_file("/proc/self/status").empty()) << "a regular file of no size";
}

TEST(ReadFile, LooksAtTheSizeFirst) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "large";
    write_file(path, "");
    fs::resize_file(path, std::uintmax_t{1} << 40); // 1 TiB of nothing
    EXPECT_EQ(error_of([&] { read_file(path); }), path.string() + ": the file is larger than 1024 MiB");
    fs::resize_file(path, 1 << 20);
    EXPECT_EQ(read_file(path, 1 << 20).size(), std::size_t{1} << 20);
    fs::resize_file(path, (1 << 20) + 1);
    EXPECT_EQ(error_of([&] { read_file(path, 1 << 20); }), path.string() + ": the file is larger than 1 MiB");
}

} // namespace
} // namespace sandbox
