#include "commands/common.h"

#include "capture/sidecar.h"
#include "commands/commands.h"
#include "image/error.h"
#include "image/image_file.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace sandbox {
namespace {

constexpr int longest_side = 16384;
constexpr long most_pixels = 64L << 20;

/// A view brings its own camera, so that a --set of the scene's would be lost without a word.
void refuse_lost_settings(const CommonOptions &common) {
    for (const std::string &setting : common.settings) {
        if (setting.starts_with("camera")) {
            throw InputError("--set " + setting + ": has no effect with --view, which brings its own camera");
        }
    }
}

} // namespace

Assets scene_assets(const CommonOptions &common) { return Assets("assets", common.assets); }
Assets shader_assets(const CommonOptions &common) { return Assets("shaders", common.shaders); }

Scene open_scene(const CommonOptions &common, const std::string &name, const std::string &view) {
    Scene scene = open_scene(name, scene_assets(common));
    for (const std::string &setting : common.settings) {
        scene = with_setting(scene, setting);
    }
    if (view.empty()) {
        return scene;
    }
    refuse_lost_settings(common);
    return with_view(std::move(scene), view);
}

std::optional<PictureOptions> sidecar_of(const std::string &scene) {
    const std::filesystem::path path(scene);
    if (path.extension() != ".json" || !std::filesystem::is_regular_file(path)) {
        return std::nullopt;
    }
    auto options = sidecar_options(read_file(path), scene);
    if (options) {
        with_flag(scene + ": size", [&] { check_size(options->size); });
        check_positive(scene + ": exposure", options->exposure);
        check_positive(scene + ": gain", options->gain);
    }
    return options;
}

void check_size(Size size) {
    const auto side_ok = [](int side) { return side >= 1 && side <= longest_side; };
    if (!side_ok(size.width) || !side_ok(size.height) || static_cast<long>(size.width) * size.height > most_pixels) {
        throw InputError("expected WIDTHxHEIGHT with 1 to 16384 each and at most 64 Mpixel in all, got " +
                         std::to_string(size.width) + "x" + std::to_string(size.height));
    }
}

Size parse_size(std::string_view text) {
    Size size;
    const char *const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        if (height.ec == std::errc() && height.ptr == end) {
            with_flag("--size", [&] { check_size(size); });
            return size;
        }
    }
    throw InputError("--size: expected WIDTHxHEIGHT such as 1280x720, got '" + std::string(text) + "'");
}

void check_positive(std::string_view flag, double value) {
    if (!std::isfinite(value) || value <= 0) {
        throw InputError(std::string(flag) + ": expected a number > 0, got " + std::to_string(value));
    }
}

std::string check_output(const std::filesystem::path &out, std::initializer_list<std::string_view> allowed) {
    std::string ending = out.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::find(allowed.begin(), allowed.end(), ending) == allowed.end()) {
        std::string expected;
        for (const std::string_view a : allowed) {
            expected += (expected.empty() ? "" : " or ") + std::string(a);
        }
        throw InputError("--out: expected a file name that ends in " + expected + ", got '" + out.string() + "'");
    }
    if (out.has_parent_path() && !std::filesystem::is_directory(out.parent_path())) {
        throw InputError("--out: there is no folder '" + out.parent_path().string() + "'");
    }
    return ending;
}

void make_folder(const std::filesystem::path &out) {
    std::error_code failed;
    std::filesystem::create_directories(out, failed);
    if (!std::filesystem::is_directory(out)) {
        throw InputError("--out: cannot make the folder '" + out.string() + "'");
    }
}

void print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
        throw InputError(std::string("cannot write to standard output: ") + std::strerror(errno));
    }
}

void note(std::string_view text) {
    while (text.ends_with('\n')) {
        text.remove_suffix(1);
    }
    std::fprintf(stderr, "shading-sandbox: %.*s\n", static_cast<int>(text.size()), text.data());
}

void add_common_options(CLI::App &app, CommonOptions &common) {
    const std::string group = "Common options";
    CLI::Validator folder = CLI::ExistingDirectory;
    folder.description(""); // else it is said twice
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&common](const std::vector<std::string> &values) {
               common.settings.insert(common.settings.end(), values.begin(), values.end());
           },
           "Change the scene before use, e.g. --set lights[0].diffuse=0.5; repeatable")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false)
        ->group(group);
    app.add_option("--shaders", common.shaders, "Read the shader parts from this folder")
        ->type_name("DIR")
        ->check(folder)
        ->group(group);
    app.add_option("--assets", common.assets, "Read scenes, lessons, textures and models from this folder")
        ->type_name("DIR")
        ->check(folder)
        ->group(group);
    app.add_option_function<std::string>(
           "--backend",
           [&common](const std::string &name) { common.backend = name == "glfw" ? Backend::glfw : Backend::egl; },
           "Where OpenGL comes from when there is no window [egl]")
        ->type_name("egl|glfw")
        ->check(CLI::IsMember({"egl", "glfw"}).description(""))
        ->group(group);
    app.add_flag("-v", common.verbose, "Say more on standard error: the renderer, programs built, times")->group(group);
    app.footer(app.get_footer() + (app.get_footer().empty() ? "" : "\n") +
               "What SCENE and T can be, and the exit codes: shading-sandbox --help");
}

} // namespace sandbox
