#pragma once

#include "capture/picture.h"
#include "measure/report/report.h"
#include "measure/report/stability_report.h"
#include "ui/session/session.h"

#include <filesystem>
#include <string>

namespace sandbox {

/// The options of a capture that shows what the views show now; `each` is the size of one view.
PictureOptions picture_options(const Session &session, Size each);

/// `name`-001.png, or the first number that is free in `folder`: a capture never overwrites a file.
std::filesystem::path free_name(const std::filesystem::path &folder, const std::string &name);

/// Makes `name`-001 in `folder`, or the first number that is free. Throws InputError.
std::filesystem::path new_folder(const std::filesystem::path &folder, const std::string &name);

/// The folder that captures go to: the current one, else the user's Pictures, else the home folder. Throws InputError
/// if none of them can be written.
std::filesystem::path capture_folder();

/// What the commands `report` and `stability` write (.html, .json, .csv), in a new folder `name`-report-001 or
/// stability-001 of the capture folder. Both return the folder, absolute, and throw InputError.
std::filesystem::path export_report(const ReportRun &run, const std::string &name);
std::filesystem::path export_stability(const StabilityRun &run);

} // namespace sandbox
