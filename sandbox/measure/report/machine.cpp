#include "measure/report/report.h"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>
#include <utility>

namespace sandbox {
namespace {

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return {};
}

std::string build_name() {
#ifdef NDEBUG
    const std::string kind = "release";
#else
    const std::string kind = "debug";
#endif
#ifdef __clang__
    return kind + ", clang " + __clang_version__;
#else
    return kind + ", gcc " + __VERSION__;
#endif
}

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
    return text;
}

} // namespace

Machine this_machine() {
    const char *const llvmpipe_threads = std::getenv("LP_NUM_THREADS");
    return {.renderer = {},
            .opengl = {},
            .processor = processor_name(),
            .threads = static_cast<int>(std::thread::hardware_concurrency()),
            .llvmpipe_threads = llvmpipe_threads != nullptr ? llvmpipe_threads : "",
            .build = build_name(),
            .clock = {}};
}

ReportRun new_report_run(std::string renderer, std::string opengl, std::string clock) {
    ReportRun run;
    run.machine = this_machine();
    run.machine.renderer = std::move(renderer);
    run.machine.opengl = std::move(opengl);
    run.machine.clock = std::move(clock);
    run.version = SANDBOX_VERSION;
    run.date = utc_now();
    return run;
}

} // namespace sandbox
