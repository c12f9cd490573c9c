#pragma once

#include "measure/work_precision/run.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A measurement as files: report.html for people, report.json and report.csv for programs.
namespace sandbox {

/// Where a run's times were taken.
struct Machine {
    std::string renderer, opengl; ///< GL_RENDERER, GL_VERSION
    std::string processor;        ///< "Intel(R) Xeon(R) ..."; empty if unknown
    int threads = 0;              ///< of the processor
    std::string llvmpipe_threads; ///< LP_NUM_THREADS; empty: not set
    std::string build;            ///< "release" or "debug", and the compiler
    std::string clock;            ///< what every time was taken with
    bool operator==(const Machine &) const = default;
};
/// All but renderer, opengl and clock.
Machine this_machine();

struct ReportPicture {
    std::string title, caption;
    ByteImage image;
};

struct ReportRun {
    WorkPrecision measured;
    Machine machine;
    std::string version; ///< of the program
    std::string date;    ///< UTC, "2031-05-01 12:00"
    bool quick = false;
    std::vector<ReportPicture> pictures; ///< HTML only
};

/// A run that begins now, on this machine, by this version; nothing is measured yet.
ReportRun new_report_run(std::string renderer, std::string opengl, std::string clock);

/// {"format": ..., "runs": [...]}; the keys are documented in report_json.cpp.
std::string report_json(const std::vector<ReportRun> &runs);
/// The runs of a report.json, without their pictures. `name` is used in messages. Throws InputError.
std::vector<ReportRun> read_report_json(std::string_view text, std::string_view name);

/// One line a row, with a header; everything else that the report says of a row stands in its columns.
std::string report_csv(const std::vector<ReportRun> &runs);

/// One self-contained page. With several runs they stand side by side.
std::string report_html(const std::vector<ReportRun> &runs);

} // namespace sandbox
