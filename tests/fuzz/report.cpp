#include "measure/report/report.h"

#include "fuzz/target.h"
#include "fuzz/targets.h"
#include "measure/report/csv.h"
#include "measure/report/report_html.h"
#include "measure/report/report_json.h"
#include "tools/measured_ball.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace sandbox {

/// As `report --merge` does: reads it, then writes the page and both files.
void check_report(std::string_view bytes) {
    const auto runs = accepted([&] { return read_report_json(bytes, "report.json"); });
    if (!runs) {
        return;
    }
    const std::string written = report_json(*runs);
    held(report_json(read_report_json(written, "again.json")) == written, "a report reads back as it was");
    const std::string page = report_html(*runs);
    for (const char *wrong : {">nan", ">-nan", "\"nan", "(nan", ",nan", " nan", "-2147483648"}) {
        held(page.find(wrong) == std::string::npos || bytes.find("nan") != std::string::npos ||
                 bytes.find("-2147483648") != std::string::npos,
             std::string("no number on a page is ") + wrong);
    }
    held(
        std::ranges::none_of(page, [](char c) { return static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t'; }),
        "a page holds no control character");
    held(!report_csv(*runs).empty(), "a report has a table");
}

namespace {

/// A ball on two meshes, by pictures of the reference.
ReportRun small_run(const std::vector<Technique> &techniques, Size size) {
    Scene scene;
    scene.name = "Ball";
    scene.lights = {Light{}};
    scene.lights[0].position = {1, 2, 3};
    return measured_ball(scene, {size, 8, 16, 1, 3, techniques});
}

/// Without what no reader reads, on one line: small.
std::string seed_of(const std::vector<ReportRun> &runs) {
    auto json = nlohmann::ordered_json::parse(report_json(runs));
    for (auto &run : json["runs"]) {
        run.erase("findings");
    }
    return json.dump();
}

} // namespace

std::vector<std::string> report_seeds() {
    const ReportRun one = small_run({parse_technique("per-pixel/phong")}, {8, 6});
    ReportRun two =
        small_run({parse_technique("per-vertex/phong"), parse_technique("per-pixel/phong:gate=none")}, {8, 6});
    two.measured.rows[0].refused = "too many lights";
    two.measured.no_analytic_surface = "a mesh from a file";
    return {seed_of({one}), seed_of({two}), seed_of({one, two})};
}

} // namespace sandbox
