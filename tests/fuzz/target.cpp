#include "fuzz/target.h"

#include "fuzz/targets.h"
#include "image/file_io.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <stdexcept>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

constexpr FuzzTarget targets[]{
    {"obj", check_obj, obj_seeds},
    {"mtl", check_mtl, mtl_seeds},
    {"png", check_png, png_seeds},
    {"jpeg", check_jpeg, jpeg_seeds},
    {"pfm", check_pfm, pfm_seeds},
    {"scene", check_scene, scene_seeds, true},
    {"sidecar", check_sidecar, sidecar_seeds, true},
    {"report", check_report, report_seeds, true},
    {"taught", check_taught, taught_seeds, true},
    {"settings", check_settings, settings_seeds, true},
    {"own", check_own, own_seeds},
    {"script", check_script, script_seeds},
};

} // namespace

std::span<const FuzzTarget> fuzz_targets() { return targets; }

const FuzzTarget &fuzz_target(std::string_view name) {
    const auto found = std::ranges::find(targets, name, &FuzzTarget::name);
    if (found == std::end(targets)) {
        throw std::out_of_range(fmt::format("no fuzz target {}", name));
    }
    return *found;
}

void held(bool condition, const std::string &what) {
    if (!condition) {
        throw std::logic_error("does not hold: " + what);
    }
}

void held_refusal(const InputError &error) {
    constexpr std::size_t most = 5000; // a path may have 64 keys of 60 bytes
    const std::string_view message = error.what();
    held(!message.empty() && message.size() <= most, fmt::format("a message of {} bytes", message.size()));
}

std::vector<std::string> files_in(const std::string &folder, std::string_view ending) {
    std::vector<fs::path> paths;
    if (const fs::path path = fs::path(SOURCE_DIR) / folder; fs::is_directory(path)) {
        for (const auto &entry : fs::directory_iterator(path)) {
            if (entry.is_regular_file() && entry.path().filename().string().ends_with(ending)) {
                paths.push_back(entry.path());
            }
        }
    }
    std::ranges::sort(paths);
    std::vector<std::string> files;
    std::ranges::transform(paths, std::back_inserter(files), [](const fs::path &path) { return read_file(path); });
    return files;
}

std::vector<std::string> kept_inputs(const std::string &folder, std::string_view target) {
    return files_in(fmt::format("tests/fuzz/{}/{}", folder, target), "");
}

} // namespace sandbox
