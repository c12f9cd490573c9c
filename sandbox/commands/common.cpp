#include "commands/common.h"

#include "capture/opening_view.h"
#include "capture/sidecar.h"
#include "image/error.h"
#include "image/image_file.h"
#include "image/plain_text.h"
#include "image/system_font.h"
#include "scene/model_scene.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"
#include "scene/scene_setting.h"
#include "shading/prepared_object.h"
#include "words/words.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

namespace sandbox {
namespace {

/// A view brings its own camera, so a --set of the scene's camera would be lost silently.
void refuse_lost_settings(const CommonOptions &common) {
    for (const std::string &setting : common.settings) {
        if (setting.starts_with("camera")) {
            throw InputError("--set {}: has no effect with --view, which brings its own camera", setting);
        }
    }
}

} // namespace

Assets scene_assets(const CommonOptions &common) { return Assets("assets", common.assets); }
Assets shader_assets(const CommonOptions &common) { return Assets("shaders", common.shaders); }

Scene open_scene(const CommonOptions &common, const std::string &name, const std::string &view,
                 std::optional<Size> drawn) {
    Scene scene = is_model(name) ? scene_of_model(name, drawn ? aspect_of(*drawn) : unknown_aspect)
                                 : open_scene(name, scene_assets(common));
    scene = with_settings(scene, common.settings, "--set", std::filesystem::current_path());
    (void)opening_view(scene, name); // for the window alone, and refused by every command if it is wrong
    if (view.empty()) {
        return scene;
    }
    refuse_lost_settings(common);
    return with_view(std::move(scene), view);
}

std::optional<PictureOptions> sidecar_of(const std::string &scene) {
    const std::filesystem::path path(scene);
    std::error_code failed; // opening it says why
    if (path.extension() != ".json" || !std::filesystem::is_regular_file(path, failed)) {
        return std::nullopt;
    }
    return sidecar_options(read_file(path, largest_json), scene, std::filesystem::absolute(path).parent_path());
}

std::string quoted(const std::string &word) {
    const bool bare = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("_-./:=,@%+").find(static_cast<char>(c)) != std::string_view::npos;
    });
    if (bare) {
        return word;
    }
    std::string out = "'";
    for (const char c : word) {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

std::string scene_arguments(const CommonOptions &common, const std::string &scene, const std::string &view) {
    std::string text = quoted(scene);
    for (const std::string &setting : common.settings) {
        text += " --set " + quoted(setting);
    }
    return text + (view.empty() ? "" : " --view " + quoted(view));
}

void note_missing_font(std::string_view language, std::string_view what) {
    if (language != languages.front() && !chinese_font()) {
        note(fmt::format(
            "no font with Chinese characters is installed (fonts-noto-cjk, fonts-wqy-microhei): {} are in English",
            what));
    }
}

void refuse_settings(const CommonOptions &common, std::string_view why) {
    if (!common.settings.empty()) {
        throw InputError("--set {}: {}", common.settings.front(), why);
    }
}

std::string check_output(const std::filesystem::path &out, std::initializer_list<std::string_view> allowed) {
    std::string ending = out.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::ranges::find(allowed, ending) == allowed.end()) {
        throw InputError("--out: expected a file name that ends in {}, got '{}'", fmt::join(allowed, " or "),
                         out.string());
    }
    std::error_code failed;
    const auto folder = std::filesystem::status(out.parent_path(), failed).type();
    if (out.has_parent_path() && folder == std::filesystem::file_type::not_found) {
        throw InputError("--out: there is no folder '{}'", out.parent_path().string());
    }
    with_flag("--out", [&] { check_writable(out); });
    return ending;
}

void make_folder(std::string_view flag, const std::filesystem::path &folder,
                 std::initializer_list<std::string_view> files) {
    std::error_code failed, ignored;
    std::filesystem::create_directories(folder, failed);
    if (failed && !std::filesystem::is_directory(folder, ignored)) {
        throw InputError("{}: cannot make the folder '{}' ({})", flag, folder.string(), failed.message());
    }
    for (const std::string_view file : files) {
        with_flag(flag, [&] { check_writable(folder / file); });
    }
}

void print(std::string_view text) {
    const std::string plain = isatty(STDOUT_FILENO) != 0 ? plain_lines(text) : ""; // a file takes it as it is
    if (!plain.empty()) {
        text = plain;
    }
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
        throw InputError("cannot write to standard output: {}", std::strerror(errno));
    }
}

void note(std::string_view text) {
    while (text.ends_with('\n')) {
        text.remove_suffix(1);
    }
    fmt::print(stderr, "shading-sandbox: {}\n", plain_lines(text));
}

void note_no_effect(const Scene &scene, const Technique &technique) {
    for (const TechniqueKey &key : settings_without_effect(scene, technique)) {
        note(fmt::format("{}={} has no effect on this scene", key.name, key.value(technique).name));
    }
}

void note_no_effect(const Scene &scene, const Technique &left, const Technique &right,
                    const std::vector<ObjectResources> &resources) {
    note_no_effect(scene, left);
    if (right != left) {
        note_no_effect(scene, right);
    }
    if (same_picture(scene, left, right, resources)) {
        note(fmt::format("{} and {} draw the same picture of this scene", to_string(left), to_string(right)));
    }
}

} // namespace sandbox
