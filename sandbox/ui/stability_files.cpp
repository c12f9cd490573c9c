#include "ui/stability_files.h"

#include "image/image_file.h"
#include "ui/capture_files.h"

namespace sandbox {

std::filesystem::path write_stability(const StabilityRun &run) {
    std::filesystem::path folder = std::filesystem::absolute(new_folder(capture_folder(), "stability"));
    write_file(folder / "stability.html", stability_html(run));
    write_file(folder / "stability.json", stability_json(run));
    write_file(folder / "stability.csv", stability_csv(run));
    return folder;
}

} // namespace sandbox
