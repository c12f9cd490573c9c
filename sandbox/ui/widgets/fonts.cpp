#include "ui/widgets/fonts.h"

#include <cstdlib>
#include <filesystem>
#include <imgui.h>
#include <initializer_list>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace sandbox {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders;
    if (const char *home = std::getenv("HOME")) {
        folders.push_back(fs::path(home) / ".local/share/fonts");
        folders.push_back(fs::path(home) / ".fonts");
    }
    folders.insert(folders.end(), {"/usr/local/share/fonts", "/usr/share/fonts"});
    return folders;
}

/// All font files below the usual folders; skips folders that cannot be read.
std::vector<fs::path> font_files() {
    std::vector<fs::path> files;
    for (const fs::path &folder : font_folders()) {
        std::error_code error;
        fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
        while (!error && at != fs::recursive_directory_iterator()) {
            if (at->path().extension() == ".ttf") {
                files.push_back(at->path());
            }
            at.increment(error);
        }
    }
    return files;
}

std::optional<fs::path> find_font(const std::vector<fs::path> &files, std::initializer_list<const char *> names) {
    for (const char *name : names) {
        for (const fs::path &file : files) {
            std::error_code error;
            if (file.filename() == name && fs::file_size(file, error) > 0 && !error) {
                return file;
            }
        }
    }
    return std::nullopt;
}

void add_font(const std::optional<fs::path> &file, float pixels) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    if (!file) {
        ImFontConfig config;
        config.SizePixels = pixels;
        atlas.AddFontDefault(&config);
        return;
    }
    // Latin, Greek, Cyrillic (names of files may hold them), punctuation, arrows, signs.
    static const ImWchar glyphs[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x04FF, 0x2010, 0x2027,
                                     0x2030, 0x203A, 0x2190, 0x2199, 0x2212, 0x2212, 0};
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    atlas.AddFontFromFileTTF(file->c_str(), pixels, &config, glyphs);
}

} // namespace

void load_fonts(float scale) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    const std::vector<fs::path> files = font_files();
    const auto text = find_font(files, {"NotoSans-Regular.ttf", "DejaVuSans.ttf", "LiberationSans-Regular.ttf",
                                        "FreeSans.ttf", "Ubuntu-R.ttf"});
    add_font(text, 16 * scale);
    add_font(find_font(files, {"NotoSansMono-Regular.ttf", "DejaVuSansMono.ttf", "LiberationMono-Regular.ttf",
                               "FreeMono.ttf", "UbuntuMono-R.ttf"}),
             15 * scale);
    add_font(text, 24 * scale);
}

ImFont *code_font() { return ImGui::GetIO().Fonts->Fonts[1]; }
ImFont *lecture_font() { return ImGui::GetIO().Fonts->Fonts[2]; }

} // namespace sandbox
