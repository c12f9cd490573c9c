#include "commands/process.h"

#include <cstdlib>
#include <sys/wait.h>

namespace sandbox {
namespace {

std::string quoted(const std::string &text) {
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

} // namespace

ProcessResult run_sandbox(const Arguments &arguments, const std::string &setup, const std::string &redirect) {
    const TemporaryFolder folder;
    std::string line = setup + " " + quoted(SANDBOX_EXE);
    for (const std::string &argument : arguments) {
        line += " " + quoted(argument);
    }
    const char *profile = std::getenv("SANDBOX_TESTED_PROFILE"); // as gl_test.h
    if (profile != nullptr && !arguments.empty() && !arguments.front().starts_with('-')) {
        line += " --profile " + quoted(profile);
    }
    line += " > " + quoted(folder.file("out")) + " 2> " + quoted(folder.file("err")) + " " + redirect;
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.read("out"), folder.read("err")};
}

} // namespace sandbox
