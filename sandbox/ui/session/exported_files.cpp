#include "ui/session/exported_files.h"

#include "image/image_file.h"
#include "measure/report/csv.h"
#include "measure/report/report_html.h"
#include "measure/report/report_json.h"
#include "ui/session/capture_files.h"

namespace sandbox {

namespace {

struct Texts {
    std::string html, json, csv;
};

std::filesystem::path write_all(const std::string &folder_name, const std::string &stem, const Texts &texts) {
    std::filesystem::path folder = std::filesystem::absolute(new_folder(capture_folder(), folder_name));
    write_file(folder / (stem + ".html"), texts.html);
    write_file(folder / (stem + ".json"), texts.json);
    write_file(folder / (stem + ".csv"), texts.csv);
    return folder;
}

} // namespace

std::filesystem::path export_report(const ReportRun &run, const std::string &name) {
    return write_all(name + "-report", "report", {report_html({run}), report_json({run}), report_csv({run})});
}

std::filesystem::path export_stability(const StabilityRun &run) {
    return write_all("stability", "stability", {stability_html(run), stability_json(run), stability_csv(run)});
}

} // namespace sandbox
