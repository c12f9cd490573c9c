#include "measure/report/report.h"

#include "measure/report/csv.h"
#include "measure/report/html.h"
#include "measure/report/report_html.h"
#include "measure/report/report_json.h"
#include "measure/report/text.h"
#include "measure/work_precision/findings.h"
#include "tools/error_of.h"
#include "tools/measured_ball.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

namespace sandbox {
namespace {

/// A ball on three rungs, measured with pictures of the reference and times that grow with the mesh.
ReportRun ball_run() {
    Scene scene;
    scene.name = "Ball, \"round\" <b>";
    Light light;
    light.position = {1, 2, 3};
    light.attenuation = {0.5, 0.1, 0.1};
    scene.lights = {light};
    ReportRun run = measured_ball(scene, {{16, 12}, 8, 32, 4, 5});
    run.pictures = {{"The truth", "caption", ByteImage{{2, 1}, std::vector<std::uint8_t>(6, 200)}, {}}};
    return run;
}

/// The cells of a line of CSV.
std::vector<std::string> cells_of(const std::string &line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
                cells.back() += line[++i];
            } else {
                quoted = !quoted;
            }
        } else if (line[i] == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += line[i];
        }
    }
    return cells;
}

TEST(ReportJson, HoldsEveryRowAndReadsBack) {
    const ReportRun run = ball_run();
    const std::string text = report_json({run});
    const auto json = nlohmann::json::parse(text);
    const auto &rows = json["runs"][0]["rows"];
    ASSERT_EQ(rows.size(), run.measured.rows.size());
    EXPECT_EQ(rows[0]["errors"]["rmse"], run.measured.rows[0].errors->total.norms.rmse) << "to the last digit";
    EXPECT_EQ(rows[0]["time"]["samples"].size(), 5U);
    for (const char *key : {"orders", "pareto", "cheapest", "specialisation", "power", "claims"}) {
        EXPECT_FALSE(json["runs"][0]["findings"][key].empty()) << key;
    }
    EXPECT_EQ(report_json(read_report_json(text, "a.json")), text);
}

/// Of which `compared` of 10 pixels count and the others are at edges; its errors are small.
void mask(MeasuredRow &row, std::size_t compared) {
    Metrics &total = row.errors->total;
    total = Metrics{};
    total.compared_pixels = compared;
    total.edge_pixels = 10 - compared;
    total.edge_max_abs = 0.5;
    total.norms = {1e-9, 1e-9, 1e-9, 1e-9};
    settle(total);
    row.time = run_time({0.001, 0.001, 0.001, 0.001, 0.001}); // by far the fastest
}

/// Less than half of what is shown says too little: such rows are marked everywhere and recommended nowhere.
TEST(Report, RowsOfWhichTooLittleIsComparedAreMarked) {
    ReportRun run = ball_run();
    WorkPrecision &m = run.measured;
    std::vector<std::size_t> base;
    for (std::size_t i = 0; i < m.rows.size(); ++i) {
        if (is_base(m.rows[i]) && m.rows[i].plan.technique.model == Model::phong) {
            base.push_back(i);
        }
    }
    ASSERT_GE(base.size(), 3U);
    mask(m.rows[base[0]], 0);
    mask(m.rows[base[1]], 4);
    mask(m.rows[base[2]], 5); // half is enough
    EXPECT_EQ(marked_rows(m), 2U);
    for (const ErrorNorm norm : error_norms) {
        EXPECT_EQ(pareto_front(m, Model::phong, norm), (std::vector<std::size_t>{base[2]}));
        EXPECT_EQ(cheapest(m, Model::phong, norm, 1e-5), base[2]);
    }
    const std::string text = report_json({run});
    const auto json = nlohmann::json::parse(text)["runs"][0];
    const auto &none = json["rows"][base[0]];
    for (const char *key : {"rmse", "max_abs", "psnr", "max_levels", "differing_share", "jump_max_abs"}) {
        EXPECT_TRUE(none["errors"][key].is_null()) << key;
    }
    EXPECT_EQ(none["errors"]["compared_share"], 0);
    EXPECT_EQ(none["errors"]["edge_max_abs"], 0.5);
    EXPECT_EQ(none["marked"], "none of the 10 pixels that show an object are compared; left out: edge 10");
    EXPECT_EQ(json["rows"][base[1]]["errors"]["compared_share"], 0.4);
    EXPECT_FALSE(json["rows"][base[1]]["marked"].is_null());
    EXPECT_TRUE(json["rows"][base[2]]["marked"].is_null());
    const auto again = read_report_json(text, "a.json");
    EXPECT_EQ(report_json(again), text);
    EXPECT_EQ(marked_rows(again[0].measured), 2U) << "null is read as nothing compared, not as no error";
    EXPECT_NE(report_html({run}).find("none of the 10 pixels"), std::string::npos);
    EXPECT_NE(report_html({run}).find("Rows of which less than half is compared"), std::string::npos);
    std::istringstream lines(report_csv({run}));
    std::string line;
    std::getline(lines, line);
    const auto head = cells_of(line);
    for (std::size_t i = 0; i <= base[0]; ++i) {
        std::getline(lines, line);
    }
    const auto cells = cells_of(line);
    const auto cell = [&](const char *name) {
        return cells[static_cast<std::size_t>(std::ranges::find(head, name) - head.begin())];
    };
    EXPECT_EQ(cell("rmse"), "") << "neither 0 nor inf";
    EXPECT_EQ(cell("psnr"), "") << "not inf, as of identical pictures";
    EXPECT_EQ(cell("compared_share"), "0");
    EXPECT_EQ(cell("edge_max_abs"), "0.5");
    EXPECT_EQ(cell("jump_max_abs"), "");
    EXPECT_EQ(cell("pareto_rmse"), "0");
    EXPECT_NE(cell("marked").find("none of the 10"), std::string::npos);
}

TEST(ReportJson, InfiniteErrorsReadBackAsInfinite) {
    ReportRun run = ball_run();
    Metrics &total = run.measured.rows[0].errors->total;
    total.nonfinite_pixels = 1;
    settle(total);
    const auto again = read_report_json(report_json({run}), "a.json");
    EXPECT_TRUE(std::isinf(again[0].measured.rows[0].errors->total.norms.rmse));
}

TEST(ReportJson, SeveralRunsStandSideBySide) {
    ReportRun other = ball_run();
    other.machine.renderer = "another";
    const std::string both = report_json({ball_run(), other});
    const auto runs = read_report_json(both, "a.json");
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[1].machine.renderer, "another");
    const std::string html = report_html(runs);
    EXPECT_NE(html.find("Runs side by side"), std::string::npos);
    EXPECT_NE(html.find("Run 2: another"), std::string::npos);
}

TEST(ReportJson, OtherFilesAreRefusedByName) {
    for (const char *text :
         {"", "[]", "{}", "{\"format\": \"something else\"}", "{\"format\": 1}",
          "{\"format\": \"shading-sandbox report 1\"}", "{\"format\": \"shading-sandbox report 1\", \"runs\": [{}]}",
          "{\"format\": \"shading-sandbox report 1\", \"runs\": 3}"}) {
        const std::string said = error_of([&] { read_report_json(text, "a.json"); });
        EXPECT_EQ(said.rfind("a.json:", 0), 0U) << text << ": " << said;
    }
}

TEST(ReportJson, NumbersThatNoReportHasAreRefused) {
    const std::string good = report_json({ball_run()});
    const std::vector<std::tuple<std::string, nlohmann::json, std::string>> wrong{
        {"/runs/0/size/0", -5, "runs[0]: size/0: expected a whole number from 0 to 1e9, got -5"},
        {"/runs/0/size/1", 1e300, "runs[0]: size/1: expected a whole number from 0 to 1e9, got 1e+300"},
        {"/runs/0/size/1", 20000, "runs[0]: size: "},
        {"/runs/0/repeats", 0.5, "runs[0]: repeats: expected a whole number from 0 to 1e9, got 0.5"},
        {"/runs/0/machine/threads", true, "runs[0]: machine/threads: expected a whole number"},
        {"/runs/0/meshes/1/rings", 1e300,
         "runs[0]: meshes[1]: rings: expected a whole number from 0 to 1e6, got 1e+300"},
        {"/runs/0/meshes/0/triangles", -1,
         "runs[0]: meshes[0]: triangles: expected a whole number from 0 to 1e12, got -1"},
        {"/runs/0/rows/2/mesh", 0.9, "runs[0]: rows[2]: mesh: expected a whole number"},
        {"/runs/0/rows/2/mesh", 99, "runs[0]: rows[2]: mesh: there is no such mesh"},
        {"/runs/0/rows/2/errors/compared_pixels", -1, "runs[0]: rows[2]: compared_pixels: expected a whole number"},
        {"/runs/0/rows/2/time/samples/0", 0, "runs[0]: rows[2]: time.samples: expected milliseconds > 0, got 0"},
        {"/runs", nlohmann::json::array(), "runs: expected one or more"}};
    for (const auto &[key, value, said] : wrong) {
        auto json = nlohmann::json::parse(good);
        json.at(nlohmann::json::json_pointer(key)) = value;
        const std::string error = error_of([&] { read_report_json(json.dump(), "a.json"); });
        EXPECT_TRUE(error.starts_with("a.json: " + said)) << key << ": " << error;
    }
}

TEST(ReportCsv, EveryLineHasEveryColumn) {
    const ReportRun run = ball_run();
    std::istringstream lines(report_csv({run}));
    std::string line;
    std::getline(lines, line);
    const auto head = cells_of(line);
    const auto column = [&](const std::string &name) {
        return static_cast<std::size_t>(std::ranges::find(head, name) - head.begin());
    };
    std::size_t count = 0;
    while (std::getline(lines, line)) {
        const auto cells = cells_of(line);
        ASSERT_EQ(cells.size(), head.size()) << line;
        const MeasuredRow &row = run.measured.rows[count++];
        EXPECT_EQ(cells[column("scene")], run.measured.scene.name);
        EXPECT_EQ(cells[column("technique")], to_string(row.plan.technique));
        EXPECT_EQ(std::stod(cells[column("rmse")]), row.errors->total.norms.rmse);
        EXPECT_EQ(std::stod(cells[column("median_ms")]), row.time->median);
    }
    EXPECT_EQ(count, run.measured.rows.size());
}

TEST(ReportFiles, HoldEveryQuantityOfTheTables) {
    const ReportRun run = ball_run();
    const auto row = nlohmann::json::parse(report_json({run}))["runs"][0]["rows"][0];
    const std::string csv = report_csv({run});
    const std::string head = "," + csv.substr(0, csv.find("\r\n")) + ",";
    const auto has_column = [&](const std::string &name) { return head.find("," + name + ",") != std::string::npos; };
    for_each_metric(Metrics{}, [&](const auto &metric, const auto &) {
        EXPECT_EQ(row["errors"].contains(metric.name), !metric.costly) << metric.name;
        EXPECT_EQ(has_column(std::string(metric.name)), !metric.costly) << metric.name;
    });
    for (const ErrorPart &part : error_parts) {
        for (const Quantity<Norms> &norm : norm_quantities) {
            EXPECT_TRUE(row["errors"]["split"][part.name].contains(norm.name)) << part.name << norm.name;
            EXPECT_TRUE(has_column(std::string(part.name) + "_" + std::string(norm.name))) << part.name << norm.name;
        }
    }
    for (const Quantity<RunTime> &time : run_time_quantities) {
        EXPECT_TRUE(row["time"].contains(time.name)) << time.name;
        EXPECT_TRUE(has_column(std::string(time.name) + "_ms")) << time.name;
    }
}

TEST(ReportHtml, IsOneSelfContainedPage) {
    const std::string html = report_html({ball_run()});
    EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0U);
    for (const char *part : {"<svg", "data:image/png;base64,iVBOR", "prefers-color-scheme: dark", "@media print",
                             "Ball, &quot;round&quot; &lt;b&gt;", "per-pixel/blinn-phong"}) {
        EXPECT_NE(html.find(part), std::string::npos) << part;
    }
    for (const char *outside : {"src=\"http", "href=", "@import", "url("}) {
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
    }
    for (const char *tag : {"table", "section", "svg", "div", "tr", "td", "g"}) {
        const auto count = [&](const std::string &text) {
            std::size_t n = 0;
            for (auto at = html.find(text); at != std::string::npos; at = html.find(text, at + 1)) {
                ++n;
            }
            return n;
        };
        const std::string name(tag);
        EXPECT_EQ(count("<" + name + " ") + count("<" + name + ">"), count("</" + name + ">")) << tag;
    }
}

TEST(ReportHtml, NamesNoFlagOfTheCommandLine) {
    ReportRun run = ball_run();
    run.quick = true;
    const std::string html = report_html({run});
    const std::size_t end_of_style = html.find("</style>");
    EXPECT_NE(html.find("A quick overview"), std::string::npos);
    EXPECT_EQ(html.find(" --", end_of_style), std::string::npos);
}

TEST(ReportHtml, SaysThatItIsIncompleteAndSurvivesHavingNothing) {
    ReportRun run = ball_run();
    run.measured.finished = false;
    for (MeasuredRow &row : run.measured.rows) {
        row.time.reset();
    }
    EXPECT_NE(report_html({run}).find("Incomplete"), std::string::npos);
    run.measured.rows[0].errors.reset();
    run.measured.rows[1].refused = "too <many>";
    EXPECT_NE(report_html({run}).find("too &lt;many&gt;"), std::string::npos);
    run.measured.rows.clear();
    EXPECT_NE(report_html({run}).find("</html>"), std::string::npos);
    EXPECT_EQ(read_report_json(report_json({run}), "a").size(), 1U);
}

TEST(ReportText, NumbersAndEntities) {
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(0.12345), "0.123");
    EXPECT_EQ(short_number(12.345), "12.3");
    EXPECT_EQ(short_number(4.56e-7), "4.56e-07");
    EXPECT_EQ(short_number(1.0 / 0.0), "not finite");
    EXPECT_EQ(html::escaped("a<b&\"c\">"), "a&lt;b&amp;&quot;c&quot;&gt;");
    EXPECT_EQ(html::base64(""), "");
    EXPECT_EQ(html::base64("M"), "TQ=="); // RFC 4648
    EXPECT_EQ(html::base64("Ma"), "TWE=");
    EXPECT_EQ(html::base64("Man"), "TWFu");
}

} // namespace
} // namespace sandbox
