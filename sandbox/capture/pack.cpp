#include "capture/pack.h"

#include "image/error.h"
#include "image/file_io.h"
#include "image/plain_text.h"
#include "scene/scene_setting.h"
#include "shading/own_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <span>
#include <string_view>
#include <utility>

namespace sandbox {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 1> texture_folders{"textures/"};
constexpr std::array<std::string_view, 2> model_folders{"models/", "stability/"};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

class Packer {
  public:
    Packer(const Assets &assets, fs::path folder, const std::set<std::string> &taken)
        : assets_(assets), folder_(std::move(folder)) {
        for (const std::string &name : taken) {
            taken_.insert(lower(name));
        }
    }

    /// What a file of the pack says in place of a texture's or a model's path. `folders`: of built-in ones.
    std::string file(const std::string &path, std::span<const std::string_view> folders) {
        if (path.empty()) {
            return path;
        }
        if (fs::path(path).is_absolute()) {
            return named(path, [&] { return read_file(path); });
        }
        for (const std::string_view below : folders) { // built-in ones of --assets are not in every program
            const fs::path file = assets_.folder() / below / path;
            std::error_code ignored;
            if (!assets_.folder().empty() && fs::is_regular_file(file, ignored)) {
                return named(file.string(), [&] { return read_file(file); });
            }
        }
        return path;
    }

    void technique(Technique &technique) {
        if (technique.own && !technique.own.is_trusted()) {
            const std::string text = technique.own->text;
            const std::string name = named(technique.own->file, [&] { return text; });
            technique.own = OwnShader((fs::absolute(folder_) / name).lexically_normal().string(), text);
        }
    }

    std::vector<OutputFile> take_files() { return std::move(files_); }

  private:
    const Assets &assets_;
    fs::path folder_;
    std::set<std::string> taken_; ///< in lower case, for some disks know no other
    std::map<std::string, std::string> names_;
    std::vector<OutputFile> files_;

    template <class Read> std::string named(const std::string &path, const Read &read) {
        std::string &name = names_[path];
        if (name.empty()) {
            const fs::path file = fs::path(path).filename();
            name = file.string();
            for (int number = 2; !taken_.insert(lower(name)).second; ++number) {
                name = fmt::format("{}-{}{}", file.stem().string(), number, file.extension().string());
            }
            files_.push_back({folder_ / name, read()});
        }
        return "./" + name;
    }
};

} // namespace

Pack pack_of(const Scene &scene, const PictureOptions &options, const std::optional<Grid> &grid, const Assets &assets,
             const fs::path &folder, const std::set<std::string> &taken) {
    Pack pack{scene, options, grid, {}};
    Packer packer(assets, folder, taken);
    for (Object &object : pack.scene.objects) {
        object.material.texture = packer.file(object.material.texture, texture_folders);
        if (auto *obj = std::get_if<ObjShape>(&object.mesh)) {
            obj->path = packer.file(obj->path, model_folders);
        }
    }
    packer.technique(pack.options.left);
    packer.technique(pack.options.right);
    if (pack.grid) {
        pack.grid->folder = fs::absolute(folder);
        std::ranges::for_each(pack.grid->techniques, [&](Technique &technique) { packer.technique(technique); });
        for (std::string &value : pack.grid->sweep.values) {
            if (names_file(pack.grid->sweep.path)) {
                const bool models = pack.grid->sweep.path.ends_with("obj");
                value = packer.file(file_of_value(*grid, value),
                                    models ? std::span<const std::string_view>(model_folders) : texture_folders);
            }
        }
    }
    pack.files = packer.take_files();
    return pack;
}

void refuse_other_files(const fs::path &folder, const std::set<std::string> &names) {
    for (const auto &entry : fs::directory_iterator(folder)) {
        if (const std::string name = entry.path().filename().string(); !names.contains(name)) {
            throw InputError(
                "'{}' holds other files ({}); expected a new or an empty folder, or one with the same files",
                folder.string(), plain_text(name));
        }
    }
}

} // namespace sandbox
