#pragma once

#include "measure/work_precision/run.h"
#include "words/words.h"

#include <string>
#include <vector>

/// A measurement with all that its files say of it: report.html for people, report.json and report.csv for programs.
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
    std::string error; ///< "RMSE 3.05e-06"; empty: it is the truth
};

struct ReportRun {
    WorkPrecision measured;
    Machine machine;
    std::string version; ///< of the program
    std::string date;    ///< UTC, "2031-05-01 12:00"
    bool quick = false;
    std::vector<ReportPicture> pictures;       ///< HTML only
    Words words = words_in(languages.front()); ///< of the page
};

/// A run that begins now, on this machine, by this version; nothing is measured yet.
ReportRun new_report_run(std::string renderer, std::string opengl, std::string clock);

/// The truth, and the base rows of least and largest RMSE of the last model that was measured, drawn once more.
std::vector<ReportPicture> report_pictures(const Words &words, const WorkPrecision &measured, const DrawRows &draw);

} // namespace sandbox
