#pragma once

#include "commands/gl_command_test.h"
#include "image/jpeg_bytes.h"
#include "image/png_bytes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

/// What goes wrong around the program: each fault's message, exit code and the files that it leaves.
namespace sandbox {

namespace fs = std::filesystem;

/// "{}" stands for a folder of its own, which has in/, with inputs, and out/, which what is left is listed of.
struct Fault {
    const char *what;
    Arguments arguments;
    int code;
    const char *said;   ///< part of what it says; empty: it says nothing
    Arguments left{};   ///< in out/
    std::string with{}; ///< before the program, on the shell's line
    std::string redirect{};
};

inline Arguments drawing(const std::string &scene, const std::string &out = "{}/out/a.png",
                         const Arguments &more = {}) {
    Arguments all{"capture", scene, "--size", "16x16", "--out", out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}
/// With no more rights than the owner of the files, also for root.
inline std::string denied() {
    return ::geteuid() == 0 ? "setpriv --bounding-set=-dac_override,-dac_read_search "
                              "--inh-caps=-dac_override,-dac_read_search"
                            : "";
}
/// A disk of that size as out/, with what `fill` puts there. Needs the right to mount.
inline std::string on_a_disk_of(const std::string &size, const std::string &fill = "true") {
    return "unshare -m sh -c 'mount -t tmpfs -o size=" + size + " none \"{}/out\" && " + fill +
           "; \"$@\"; code=$?; ls \"{}/out\" > \"{}/left\"; exit $code' sh";
}
inline std::string interrupted(const std::string &signal, const std::string &seconds = "1.5") {
    return "timeout --preserve-status -s " + signal + " " + seconds;
}

class Faults : public GlCommandTest {
  protected:
    void SetUp() override {
        GlCommandTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) {
            return;
        }
        fmt::print("{:<44} {:>4}  {:<30} {}\n", "fault", "code", "left in out/", "message");
    }

    void expect(const std::vector<Fault> &faults) {
        for (const Fault &fault : faults) {
            expect(fault);
        }
    }

  private:
    static std::string put_in(std::string text, const std::string &folder) {
        for (std::size_t at = 0; (at = text.find("{}", at)) != std::string::npos; at += folder.size()) {
            text.replace(at, 2, folder);
        }
        return text;
    }

    static void write_inputs(const TemporaryFolder &at) {
        const auto box = [](const std::string &texture) {
            return R"({"objects": [{"mesh": {"shape": "box"}, "material": {"texture": ")" + texture + "\"}}]}";
        };
        for (const char *name : {"in", "out", "in/closed", "in/shaders", "in/folder.json"}) {
            fs::create_directory(at.path() / name);
        }
        const std::string png = png_file(png_header(2, 1, 8, png_grey), std::string("\0\x40\xFF", 3));
        for (const char *name : {"in/t.png", "in/unreadable.png", "in/closed/t.png"}) {
            at.write(name, png);
        }
        at.write("in/empty.png", "");
        at.write("in/cut.png", png.substr(0, 50));
        at.write("in/a.gif", "GIF89a");
        JpegForm form;
        const std::string jpeg = jpeg_file({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}, form);
        at.write("in/12-bit.jpg", with_byte(jpeg, jpeg_segment(jpeg, '\xc0'), 12));
        at.write("in/large.png", "");
        fs::resize_file(at.path() / "in/large.png", std::uintmax_t{1} << 31);
        ::mkfifo(at.file("in/pipe.png").c_str(), 0600);
        for (const char *name : {"t", "gone", "unreadable", "closed/t", "empty", "cut", "12-bit", "large", "pipe"}) {
            const std::string texture = std::string(name) + (std::string(name) == "12-bit" ? ".jpg" : ".png");
            at.write("in/" + fs::path(name).stem().string() + (std::string(name) == "closed/t" ? "-closed" : "") +
                         ".json",
                     box(texture));
        }
        at.write("in/gif.json", box("a.gif"));
        at.write("in/box.json", box("t.png"));
        at.write("in/cut-off.json", R"({"objects": [{"mesh")");
        at.write("in/unreadable-scene.json", "{}");
        at.write("in/closed/scene.json", "{}");
        at.write("in/up.json", R"({"camera": {"position": [0, 5, 0]}})");
        at.write("in/up-view.json",
                 R"({"views": [{"name": "a", "camera": {"position": [0, 0, 5], "up": [0, 0, -2]}}]})");
        at.write("in/bright.json", R"({"background": [0, 0, 1e7]})");
        at.write("in/escape.json", R"({"\u001b[2Jkey": 1})");
        at.write("in/technique.json", R"({"scene": {}, "techniques": ["round/phong"]})");
        at.write("in/exposure.json", R"({"scene": {}, "techniques": ["flat/phong"], "exposure": -1})");
        at.write("in/no-texture.png.json", R"({"scene": )" + box("./gone.png") + R"(, "techniques": ["flat/phong"]})");
        at.write("in/no-report.json", "{}");
        at.write("in/unreadable.obj", "v 0 0 0\n");
        at.write("in/wrong.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return 1; }\n");
        at.write("in/unreadable.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return N; }\n");
        at.write("in/file", "");
        at.write("in/answer.glsl", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return N; }\n");
        std::string script;
        fs::create_directory(at.path() / "in/answers");
        for (int i = 0; i < 100; ++i) {
            script += "size 640x480\nwait\nsize 800x600\nwait\n";
            at.write(fmt::format("in/answers/{}.glsl", i), "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return N; }\n");
        }
        at.write("in/long.script", script);
        for (const char *name : {"in/unreadable.png", "in/unreadable-scene.json", "in/unreadable.obj",
                                 "in/unreadable.glsl", "in/closed"}) {
            fs::permissions(at.path() / name, fs::perms::none);
        }
    }

    /// Rows that need a disk of their own, where nobody may mount one, are left out loudly.
    static bool can_run(const Fault &fault) {
        static const bool can_mount = std::system("unshare -m mount -t tmpfs none /tmp 2> /dev/null") == 0;
        return can_mount || fault.with.find("mount") == std::string::npos;
    }

    void expect(const Fault &fault) {
        if (!can_run(fault)) {
            fmt::print("{:<44} SKIPPED: no right to mount a disk\n", fault.what);
            return;
        }
        const TemporaryFolder at;
        write_inputs(at);
        const std::string here = at.path().string();
        Arguments arguments;
        for (const std::string &argument : fault.arguments) {
            arguments.push_back(put_in(argument, here));
        }
        const ProcessResult result = run_sandbox(arguments, put_in(fault.with, here), put_in(fault.redirect, here));
        fs::permissions(at.path() / "in/closed", fs::perms::owner_all);
        fs::permissions(at.path() / "out", fs::perms::owner_all);
        Arguments left;
        if (fs::exists(at.path() / "left")) {
            std::istringstream lines(at.read("left"));
            for (std::string line; std::getline(lines, line);) {
                left.push_back(line);
            }
        } else {
            for (const auto &entry : fs::directory_iterator(at.path() / "out")) {
                left.push_back(entry.path().filename().string());
            }
            std::ranges::sort(left);
        }
        const std::size_t own = std::min(result.err.rfind("shading-sandbox: "), result.err.size());
        std::string said = result.err.substr(own, result.err.find('\n', own) - own);
        for (std::size_t found = 0; (found = said.find(here)) != std::string::npos;) {
            said.replace(found, here.size(), "...");
        }
        fmt::print("{:<44} {:>4}  {:<30} {}\n", fault.what, result.exit_code, fmt::format("{}", fmt::join(left, " ")),
                   said);
        EXPECT_EQ(result.exit_code, fault.code) << fault.what << "\n" << result.err;
        EXPECT_NE(result.err.find(fault.said), std::string::npos) << fault.what << "\n" << result.err;
        EXPECT_EQ(left, fault.left) << fault.what << "\n" << result.err;
    }
};

} // namespace sandbox
