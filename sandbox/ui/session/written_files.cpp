#include "ui/session/written_files.h"

#include "capture/sidecar.h"
#include "image/error.h"
#include "image/image_file.h"
#include "measure/report/csv.h"
#include "measure/report/report_html.h"
#include "measure/report/report_json.h"

#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace sandbox {

namespace {

namespace fs = std::filesystem;

/// Scene names may be anything; file names hold letters, digits, dots and dashes.
std::string file_stem(const std::string &name) {
    std::string stem;
    for (const char c : name) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
        stem += plain ? c : '-';
    }
    return stem.empty() || stem.front() == '.' ? "scene" + stem : stem;
}

/// The first of name-001, name-002, ... in `folder` that `accept` takes.
fs::path first_free(const fs::path &folder, const std::string &name, const char *ending,
                    const std::function<bool(const fs::path &)> &accept) {
    for (int number = 1; number < 100000; ++number) {
        fs::path path = folder / fmt::format("{}-{:03}{}", file_stem(name), number, ending);
        if (accept(path)) {
            return path;
        }
    }
    throw InputError("{}: holds too many captures of {}", folder.string(), name);
}

fs::path write_all(const std::string &folder_name, const std::string &stem, const std::string &html,
                   const std::string &json, const std::string &csv) {
    fs::path folder = fs::absolute(new_folder(capture_folder(), folder_name));
    write_files(std::vector<OutputFile>{
        {folder / (stem + ".html"), html}, {folder / (stem + ".json"), json}, {folder / (stem + ".csv"), csv}});
    return folder;
}

} // namespace

PictureOptions picture_options(const Session &session, Size each) {
    const Document &document = session.document;
    PictureOptions options;
    options.layout = session.view.layout;
    if (options.layout == Layout::single) {
        options.flip = session.view.show_right ? FlipSide::b : FlipSide::a;
    }
    options.left = document.left;
    options.right = document.right;
    options.textbook_left = document.left_is_textbook();
    options.mesh_factors = document.mesh_factors;
    options.display = document.display;
    options.exposure = document.exposure;
    options.gain = session.view.gain;
    options.difference_of = session.view.difference_of;
    options.samples = samples_shown(session);
    options.drawn_over = session.view.drawn_over;
    options.masks = session.view.masks && options.layout != Layout::difference;
    options.divider = static_cast<double>(session.view.divider);
    options.labels = true;
    options.language = session.words.language();
    options.marks.vectors = session.view.overlay == Overlay::pixel && session.view.probed();
    options.marks.loupe = session.view.loupe && session.view.probed();
    options.marks.pixel = options.marks.vectors || options.marks.loupe ? session.view.probed() : std::nullopt;
    if (session.view.overlay == Overlay::profile) {
        options.marks.profile = session.view.profile_row;
    }
    options.marks.ring = shown_ring(session, each);
    options.size = size_around(options, {each.width * columns_of(options.layout), each.height});
    return options;
}

fs::path free_name(const fs::path &folder, const std::string &name) {
    return first_free(folder, name, ".png",
                      [](const fs::path &path) { return !fs::exists(path) && !fs::exists(sidecar_path(path)); });
}

fs::path new_folder(const fs::path &folder, const std::string &name) {
    return first_free(folder, name, "", [](const fs::path &path) {
        std::error_code error;
        const bool made = fs::create_directory(path, error);
        if (error && !fs::exists(path)) {
            throw InputError("cannot make the folder {}: {}", path.string(), error.message());
        }
        return made;
    });
}

fs::path capture_folder() {
    std::error_code error;
    std::vector<fs::path> folders{fs::current_path(error)};
    if (const char *home = std::getenv("HOME")) {
        folders.push_back(fs::path(home) / "Pictures");
        folders.emplace_back(home);
    }
    for (const fs::path &folder : folders) {
        if (fs::is_directory(folder, error) && access(folder.c_str(), W_OK) == 0) {
            return folder;
        }
    }
    throw InputError("neither the current folder nor ~/Pictures can be written");
}

fs::path export_report(const ReportRun &run, const std::string &name) {
    return write_all(name + "-report", "report", report_html({run}), report_json({run}), report_csv({run}));
}

fs::path export_stability(const StabilityRun &run) {
    return write_all("stability", "stability", stability_html(run), stability_json(run), stability_csv(run));
}

} // namespace sandbox
