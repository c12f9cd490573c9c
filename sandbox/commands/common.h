#pragma once

#include "capture/picture.h"
#include "image/error.h"
#include "image/image.h"
#include "image/picture_size.h"
#include "render/context.h"
#include "scene/assets.h"
#include "scene/resources.h"
#include "scene/scene.h"

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the commands share. User errors throw InputError naming the flag.
namespace sandbox {

struct CommonOptions {
    std::vector<std::string> settings; ///< --set PATH=VALUE, in order
    std::filesystem::path shaders;     ///< --shaders DIR; empty: the copies inside the executable
    std::filesystem::path assets;      ///< --assets DIR
    std::string backend = "egl";       ///< or "glfw"
    Profile profile = default_profile; ///< --profile core|es
    bool verbose = false;
};

Assets scene_assets(const CommonOptions &common);
Assets shader_assets(const CommonOptions &common);

/// SCENE with every --set applied and the camera of the view named `view` (empty: the scene's own camera). The camera
/// around a model fits it into views of the size `drawn` (none: of unknown_aspect).
Scene open_scene(const CommonOptions &common, const std::string &scene, const std::string &view = {},
                 std::optional<Size> drawn = {});

/// A word as a shell takes it: in quotes unless it is plain.
std::string quoted(const std::string &word);
/// SCENE as a command takes it, with what changes it: every --set, and --view unless it is empty.
std::string scene_arguments(const CommonOptions &common, const std::string &scene, const std::string &view);

/// For commands that open no SCENE. Throws InputError if there is a --set; `why` ends its message.
void refuse_settings(const CommonOptions &common, std::string_view why);

/// The options in the sidecar SCENE, checked; nothing if SCENE is not a sidecar.
std::optional<PictureOptions> sidecar_of(const std::string &scene);

/// Runs `work`; an InputError gets the flag's name in front.
template <typename Work> auto with_flag(std::string_view flag, Work work) {
    try {
        return work();
    } catch (const InputError &error) {
        throw InputError("{}: {}", flag, error.what());
    }
}

/// The ending of an output file, in lower case: ".png". Throws InputError naming --out unless it is among `allowed` and
/// the file can be written, so that no work is lost.
std::string check_output(const std::filesystem::path &out, std::initializer_list<std::string_view> allowed);

/// Makes the folder of `flag`, unless it exists. Throws InputError naming the flag unless files of those names can be
/// written into it, so that no work is lost.
void make_folder(std::string_view flag, const std::filesystem::path &folder,
                 std::initializer_list<std::string_view> files);

/// Writes a result to standard output, flushed; a terminal gets no control characters but line ends and tabs. Throws
/// InputError if it cannot be written (a full disk).
void print(std::string_view text);
/// Writes a line to standard error: "shading-sandbox: text", with no control characters but line ends and tabs.
void note(std::string_view text);
/// Notes that `what` ("labels") are in English, where `language` needs a font that is not installed.
void note_missing_font(std::string_view language, std::string_view what);
/// Notes each setting that changes no pixel of the scene.
void note_no_effect(const Scene &scene, const Technique &technique);
/// ... of both techniques, and whether they draw the same picture.
void note_no_effect(const Scene &scene, const Technique &left, const Technique &right,
                    const std::vector<ObjectResources> &resources);

constexpr Size default_picture_size{1280, 720};
constexpr std::string_view default_size = "1280x720";

} // namespace sandbox
