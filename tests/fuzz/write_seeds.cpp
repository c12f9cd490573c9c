// write_seeds TARGET FOLDER: the seeds of a target, and every input that once broke it, as files.
#include "fuzz/target.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

int main(int count, char **arguments) {
    if (count != 3) {
        std::fputs("write_seeds TARGET FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::string target = arguments[1];
        const std::filesystem::path folder = arguments[2];
        std::filesystem::create_directories(folder);
        std::vector<std::string> inputs = sandbox::fuzz_target(target).seeds();
        std::ranges::move(sandbox::kept_inputs("regressions", target), std::back_inserter(inputs));
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            std::ofstream(folder / fmt::format("seed-{:03}", i), std::ios::binary) << inputs[i];
        }
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
