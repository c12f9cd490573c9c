#include "ui/session/open_file.h"

#include "capture/opening_view.h"
#include "capture/sidecar.h"
#include "image/image_file.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace sandbox {

namespace {

bool is_builtin(const std::string &name, const Assets &assets) {
    const auto names = builtin_scenes(assets);
    return std::ranges::find(names, name) != names.end();
}

void take_sidecar(OpenedFile &file, const PictureOptions &options) {
    file.capture = true;
    file.left = options.left;
    file.textbook_left = options.textbook_left;
    file.mesh_factors = options.mesh_factors;
    file.drawn_over = options.drawn_over;
    file.masks = options.masks;
    file.marks = options.marks;
    if (options.layout != Layout::single || options.flip != FlipSide::none) {
        file.right = options.right;
        file.layout = options.layout;
    }
    file.display = options.display;
    file.exposure = options.exposure;
    if (options.layout == Layout::wipe) {
        file.divider = options.divider;
    }
    if (options.layout == Layout::difference) {
        file.gain = options.gain;
        file.difference_of = options.difference_of;
    }
}

/// What a sidecar does not say, the scene may.
void take_opening(OpenedFile &file, const OpeningView &view) {
    file.left = file.left ? file.left : view.left;
    file.right = file.right ? file.right : view.right;
    file.layout = file.layout ? file.layout : view.layout;
}

} // namespace

OpenedFile open_file(const std::string &name_or_path, const Assets &assets) {
    return open_file(name_or_path, assets, open_scene(name_or_path, assets));
}

OpenedFile open_file(const std::string &name_or_path, const Assets &assets, Scene scene) {
    OpenedFile file;
    file.scene = std::move(scene);
    const std::filesystem::path path(name_or_path);
    file.name = path.stem().string();
    if (!is_builtin(name_or_path, assets) && path.extension() == ".json") {
        if (const auto options = sidecar_options(read_file(path, largest_json), path.filename().string(),
                                                 std::filesystem::absolute(path).parent_path())) {
            take_sidecar(file, *options);
        }
    }
    take_opening(file, opening_view(file.scene, name_or_path));
    return file;
}

bool is_image_name(const std::filesystem::path &path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

OpenedFile open_text(const std::string &text) {
    OpenedFile file;
    file.name = "pasted";
    file.scene = parse_scene(text, "the clipboard", std::filesystem::current_path());
    if (const auto options = sidecar_options(text, "the clipboard")) {
        take_sidecar(file, *options);
    }
    return file;
}

Document document_from(const OpenedFile &file, const Session &session) {
    const Document &now = session.document;
    Document document =
        document_of(file.name, file.scene, file.left.value_or(now.left), file.right.value_or(now.right));
    if (file.textbook_left) {
        document.textbook = document.left;
    }
    document.mesh_factors = file.mesh_factors.value_or(now.mesh_factors);
    document.display = file.display.value_or(now.display);
    document.exposure = file.exposure.value_or(now.exposure);
    document.least_aspect = file.capture ? 0 : document.least_aspect; // its field of view has been widened already
    return document;
}

void take_view(ViewSettings &view, const OpenedFile &file) {
    view.layout = file.layout.value_or(view.layout);
    view.divider = static_cast<float>(file.divider.value_or(static_cast<double>(view.divider)));
    view.drawn_over = file.drawn_over.value_or(view.drawn_over);
    view.masks = file.masks.value_or(view.masks);
    if (file.marks) {
        view.pinned_pixel = file.marks->pixel;
        view.loupe = file.marks->loupe;
        view.profile_row = file.marks->profile.value_or(view.profile_row);
        view.overlay = file.marks->vectors ? Overlay::pixel : file.marks->profile ? Overlay::profile : Overlay::none;
    }
    view.gain = file.gain.value_or(view.gain);
    view.difference_of = file.difference_of.value_or(view.difference_of);
}

} // namespace sandbox
