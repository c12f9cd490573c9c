#include "measure/report/json_parts.h"

#include "image/error.h"
#include "scene/scene_file.h"

#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;

ReportRun run_from(const Json &json, std::string_view name) {
    ReportRun run;
    json.at("version").get_to(run.version);
    json.at("date").get_to(run.date);
    json.at("quick").get_to(run.quick);
    run.machine = report_parts::machine_from(json.at("machine"));
    run.machine.clock = json.at("clock");
    WorkPrecision &m = run.measured;
    m.scene = parse_scene(json.at("scene").dump(), std::string(name) + ": scene", {});
    m.no_analytic_surface = json.at("truth_reason");
    json.at("finished").get_to(m.finished);
    const Json &size = json.at("size");
    m.options = {{size.at(0).get<int>(), size.at(1).get<int>()},
                 json.at("first_rings").get<int>(),
                 json.at("last_rings").get<int>(),
                 json.at("warm_ups").get<int>(),
                 json.at("repeats").get<int>()};
    const Json &seconds = json.at("seconds");
    m.seconds = {seconds.at("drawing").get<double>(), seconds.at("reference").get<double>(),
                 seconds.at("metrics").get<double>(), seconds.at("other").get<double>()};
    for (const Json &mesh : json.at("meshes")) {
        m.meshes.push_back({mesh.at("rings").get<int>(),
                            mesh.at("own").get<bool>(),
                            mesh.at("ladder").get<bool>(),
                            mesh.at("triangles").get<std::size_t>(),
                            {}});
    }
    for (const Json &row : json.at("rows")) {
        m.rows.push_back(report_parts::row_from(row));
        if (m.rows.back().plan.mesh >= m.meshes.size()) {
            throw InputError("rows: mesh: there is no such mesh");
        }
    }
    for (const Json &row : json.at("omitted")) {
        m.omitted.push_back({row.at("technique"), row.at("reason")});
    }
    return run;
}

} // namespace

std::vector<ReportRun> read_report_json(std::string_view text, std::string_view name) {
    std::vector<ReportRun> runs;
    try {
        const Json json = Json::parse(text);
        if (!json.is_object() || json.value("format", "") != report_parts::format) {
            throw InputError("expected a report.json of this program (\"format\": \"" +
                             std::string(report_parts::format) + "\")");
        }
        for (const Json &run : json.at("runs")) {
            runs.push_back(run_from(run, name));
        }
    } catch (const InputError &error) {
        throw InputError(std::string(name) + ": " + error.what());
    } catch (const Json::exception &error) {
        throw InputError(std::string(name) + ": expected a report.json of this program: " + error.what());
    }
    return runs;
}

} // namespace sandbox
