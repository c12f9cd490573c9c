#include "ui/report_files.h"

#include "image/image_file.h"
#include "ui/capture_files.h"

namespace sandbox {

std::filesystem::path write_report(const ReportRun &run, const std::string &name) {
    std::filesystem::path folder = std::filesystem::absolute(new_folder(capture_folder(), name + "-report"));
    write_file(folder / "report.html", report_html({run}));
    write_file(folder / "report.json", report_json({run}));
    write_file(folder / "report.csv", report_csv({run}));
    return folder;
}

} // namespace sandbox
