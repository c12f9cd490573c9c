// report.json: {"format": "shading-sandbox report 1", "runs": [run]}. Errors are of linear colour, times milliseconds.
// run: version, date, quick, scene_name, scene (as a scene file), size, truth ("analytic surface" | "finest mesh"),
//   truth_reason (why not analytic), finished (false: stopped half-way), clock, warm_ups, repeats, first_rings,
//   last_rings, machine {renderer, opengl, processor, threads, llvmpipe_threads, build},
//   seconds {see accounting_quantities}, meshes [{rings (0: between two rungs), own, ladder, triangles}],
//   rows, omitted [{technique, reason}], precision, findings.
// row: technique, mesh (index), rings, triangles, group, refused (a reason) or
//   errors {see norm_quantities and metric_quantities (psnr null: identical), split {see error_parts: each a set of
//   norms}}, marked (why they say too little to be recommended by; null: they count) and time {see
//   run_time_quantities, samples}. Errors of a picture with pixels that are not finite are null, and so are those over
//   no pixels. certificate of the frequency auto {see certificate_quantities, nothing_proved (why; empty)}.
// precision: [{technique, rounded (levels that precision=medium changes; null: not finite), device (levels that this
//   device's mediump changes; null: unknown), high (names of values), left (levels with those highp)}].
// findings (rows by index): orders [{coarse, fine, max, l2, l1, interpolation {max, l2, l1}, settling}],
//   pareto [{model, norm, rows}], cheapest [{model, norm, bound, row (null: none)}],
//   specialisation and power [{row, base, time_ratio [lower quartile, median, upper quartile]}],
//   claims [{says, row, against, time_ratio, finding}].
#include "measure/report/report_json.h"

#include "image/error.h"
#include "image/picture_size.h"
#include "measure/work_precision/claims.h"
#include "scene/read_json.h"
#include "scene/scene_file.h"
#include "scene/table_read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view report_format = "shading-sandbox report 1";

/// Runs `work`; what it says is wrong is said with its place.
template <class Work> auto at(const std::string &place, Work work) {
    try {
        return work();
    } catch (const InputError &error) {
        throw InputError("{}: {}", place, error.what());
    }
}

/// A whole number from 0 to `high`: the library would make another number of -1, 0.9 or 1e300.
template <class T> T whole_from(const Json &json, std::string_view key, double high) {
    const double value = json.is_number() ? json.get<double>() : -1;
    if (!(value >= 0 && value <= high && std::trunc(value) == value)) {
        throw InputError("{}: expected a whole number from 0 to {}, got {}", key, number_text(high), short_json(json));
    }
    return static_cast<T>(value);
}
constexpr double most_rings = 1e6, most_triangles = 1e12, most_of_a_count = 1e9;

template <class T, std::size_t N> Json quantities_json(const Quantity<T> (&quantities)[N], const T &measured) {
    Json json = Json::object();
    for (const Quantity<T> &quantity : quantities) {
        json[quantity.name] = quantity_json<Json>(quantity, measured);
    }
    return json;
}
template <class T> void read_checked(const Json &json, const Quantity<T> &quantity, T &measured) {
    if (const auto found = json.find(quantity.name); quantity.whole() && found != json.end() && !found->is_null()) {
        whole_from<int>(*found, quantity.name, most_of_a_count);
    }
    read_quantity(json, quantity, measured);
}
template <class T, std::size_t N> T quantities_from(const Json &json, const Quantity<T> (&quantities)[N]) {
    T measured;
    for (const Quantity<T> &quantity : quantities) {
        read_checked(json, quantity, measured);
    }
    return measured;
}

Json errors_json(const RowErrors &errors) {
    Json json = Json::object();
    for_each_metric(errors.total, [&](const auto &metric, const auto &measured) {
        if (!metric.costly) {
            json[metric.name] = quantity_json<Json>(metric, measured);
        }
    });
    for (const ErrorPart &part : error_parts) {
        const auto norms = part.norms(errors.split);
        json["split"][part.name] = norms ? quantities_json(norm_quantities, *norms) : Json();
    }
    return json;
}
RowErrors errors_from(const Json &json) {
    RowErrors errors;
    for_each_metric(errors.total, [&](const auto &metric, auto &measured) {
        if (!metric.costly) {
            read_checked(json, metric, measured);
        }
    });
    for (const ErrorPart &part : error_parts) {
        const Json &norms = json.at("split").at(part.name);
        if (!norms.is_null()) {
            std::visit([&](auto member) { errors.split.*member = quantities_from(norms, norm_quantities); },
                       part.member);
        }
    }
    settle(errors.total);
    if (errors.total.nonfinite_pixels > 0) { // the parts of a drawn picture that is not finite
        errors.split.arithmetic = errors.split.quantisation = errors.total.norms;
    }
    return errors;
}

RowGroup group_from(const std::string &name) {
    constexpr std::array groups{RowGroup::ladder, RowGroup::own_mesh, RowGroup::full_program, RowGroup::baked_program,
                                RowGroup::power,  RowGroup::claim,    RowGroup::precision};
    const auto found = std::ranges::find(groups, name, [](RowGroup group) { return name_of(group); });
    if (found == groups.end()) {
        throw InputError("group: unknown value '{}'", name);
    }
    return *found;
}

Json row_json(const MeasuredRow &row, const std::vector<PlannedMesh> &meshes) {
    const PlannedMesh &mesh = meshes[row.plan.mesh];
    Json json{{"technique", to_string(row.plan.technique)},
              {"mesh", row.plan.mesh},
              {"rings", mesh.rings},
              {"triangles", mesh.triangles},
              {"group", name_of(row.plan.group)}};
    if (!row.refused.empty()) {
        json["refused"] = row.refused;
    }
    if (row.errors) {
        json["errors"] = errors_json(*row.errors);
        json["marked"] = row.mark().empty() ? Json() : Json(row.mark());
    }
    if (row.time) {
        json["time"] = quantities_json(run_time_quantities, *row.time);
        json["time"]["samples"] = row.time->samples;
    }
    if (row.certificate) {
        json["certificate"] = quantities_json(certificate_quantities, *row.certificate);
        json["certificate"]["nothing_proved"] = row.certificate->nothing_proved;
    }
    return json;
}
std::vector<double> samples_from(const Json &json) {
    auto samples = json.get<std::vector<double>>();
    if (std::ranges::any_of(samples, [](double sample) { return !(sample > 0); })) { // ratios divide by them
        throw InputError("time.samples: expected milliseconds > 0, got {}", std::ranges::min(samples));
    }
    return samples;
}
MeasuredRow row_from(const Json &json, std::size_t meshes) {
    MeasuredRow row;
    row.plan.technique = parse_technique(json.at("technique").get<std::string>());
    row.plan.mesh = whole_from<std::size_t>(json.at("mesh"), "mesh", most_of_a_count);
    if (row.plan.mesh >= meshes) {
        throw InputError("mesh: there is no such mesh");
    }
    row.plan.group = group_from(json.at("group"));
    row.refused = json.value("refused", "");
    if (json.contains("errors")) {
        row.errors = errors_from(json.at("errors"));
    }
    if (json.contains("time") && !json.at("time").at("samples").empty()) {
        row.time = run_time(samples_from(json.at("time").at("samples")));
    }
    if (const auto found = json.find("certificate"); found != json.end()) {
        row.certificate = quantities_from(*found, certificate_quantities);
        row.certificate->nothing_proved = found->at("nothing_proved").get<std::string>();
    }
    return row;
}

/// Calls `visit(key, member)` for the members that are read as they are written. `Run`: ReportRun, or const ReportRun.
template <class Run, class Visit> void for_each_plain_key(Run &run, Visit visit) {
    auto &measured = run.measured;
    visit("/version", run.version);
    visit("/date", run.date);
    visit("/quick", run.quick);
    visit("/size/0", measured.options.size.width);
    visit("/size/1", measured.options.size.height);
    visit("/truth_reason", measured.no_analytic_surface);
    visit("/finished", measured.finished);
    visit("/clock", run.machine.clock);
    visit("/warm_ups", measured.options.warm_ups);
    visit("/repeats", measured.options.repeats);
    visit("/first_rings", measured.options.first_rings);
    visit("/last_rings", measured.options.last_rings);
    visit("/machine/renderer", run.machine.renderer);
    visit("/machine/opengl", run.machine.opengl);
    visit("/machine/processor", run.machine.processor);
    visit("/machine/threads", run.machine.threads);
    visit("/machine/llvmpipe_threads", run.machine.llvmpipe_threads);
    visit("/machine/build", run.machine.build);
}

Json orders_json(const WorkPrecision &measured) {
    Json all = Json::array();
    for (const OrderStep &step : convergence_orders(measured)) {
        Json json{{"coarse", step.coarse}, {"fine", step.fine}};
        json.update(quantities_json(order_quantities, step.total));
        json["interpolation"] = quantities_json(order_quantities, step.interpolation);
        json["settling"] = name_of(step.settling);
        all.push_back(json);
    }
    return all;
}

Json quartiles_json(const TimeRatio &ratio) { return {ratio.lower_quartile, ratio.median, ratio.upper_quartile}; }

Json ratios_json(const std::vector<TimeRatio> &ratios) {
    Json all = Json::array();
    for (const TimeRatio &ratio : ratios) {
        all.push_back({{"row", ratio.row}, {"base", ratio.base}, {"time_ratio", quartiles_json(ratio)}});
    }
    return all;
}

Json findings_json(const WorkPrecision &measured) {
    Json fronts = Json::array();
    Json cheap = Json::array();
    for (const Model model : models_of(measured)) {
        for (const ErrorNorm norm : error_norms) {
            const Json of{{"model", name_of(model)}, {"norm", name_of(norm)}};
            fronts.push_back(of);
            fronts.back()["rows"] = pareto_front(measured, model, norm);
            for (const double bound : error_bounds) {
                const auto row = cheapest(measured, model, norm, bound);
                cheap.push_back(of);
                cheap.back()["bound"] = bound;
                cheap.back()["row"] = row ? Json(*row) : Json();
            }
        }
    }
    Json claims = Json::array();
    for (const Claim &claim : answer_claims(words_in(languages.front()), measured)) {
        claims.push_back({{"says", claim.says},
                          {"row", claim.row},
                          {"against", claim.against},
                          {"time_ratio", quartiles_json(claim.time)},
                          {"finding", claim.finding}});
    }
    return {{"orders", orders_json(measured)},
            {"pareto", fronts},
            {"cheapest", cheap},
            {"specialisation", ratios_json(ratios_to_base(measured, RowGroup::full_program))},
            {"baking", ratios_json(ratios_to_base(measured, RowGroup::baked_program))},
            {"power", ratios_json(ratios_to_base(measured, RowGroup::power))},
            {"claims", claims}};
}

Json levels_json(double levels) { return std::isfinite(levels) ? Json(levels) : Json(); }
double levels_from(const Json &json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

PrecisionFinding precision_from(const Json &json) {
    return {.technique = parse_technique(json.at("technique").get<std::string>()),
            .rounded = levels_from(json.at("rounded")),
            .device = json.at("device").is_null() ? std::nullopt : std::optional(levels_from(json.at("device"))),
            .high = json.at("high").get<std::vector<std::string>>(),
            .left = levels_from(json.at("left"))};
}

Json run_json(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    Json json{{"scene_name", m.scene.name},
              {"scene", Json::parse(scene_text(m.scene))},
              {"size", Json::array()},
              {"truth", m.no_analytic_surface.empty() ? "analytic surface" : "finest mesh"}};
    for_each_plain_key(run, [&](const char *key, const auto &member) { json[Json::json_pointer(key)] = member; });
    json["seconds"] = quantities_json(accounting_quantities, m.seconds);
    json["meshes"] = Json::array();
    for (const PlannedMesh &mesh : m.meshes) {
        json["meshes"].push_back(
            {{"rings", mesh.rings}, {"own", mesh.own}, {"ladder", mesh.ladder}, {"triangles", mesh.triangles}});
    }
    json["rows"] = Json::array();
    for (const MeasuredRow &row : m.rows) {
        json["rows"].push_back(row_json(row, m.meshes));
    }
    json["omitted"] = Json::array();
    for (const OmittedRow &row : m.omitted) {
        json["omitted"].push_back({{"technique", row.technique}, {"reason", row.reason}});
    }
    json["precision"] = Json::array();
    for (const PrecisionFinding &finding : m.precision) {
        json["precision"].push_back({{"technique", to_string(finding.technique)},
                                     {"rounded", levels_json(finding.rounded)},
                                     {"device", finding.device ? levels_json(*finding.device) : Json()},
                                     {"high", finding.high},
                                     {"left", levels_json(finding.left)}});
    }
    json["findings"] = findings_json(m);
    return json;
}
ReportRun run_from(const Json &json) {
    ReportRun run;
    for_each_plain_key(run, [&]<class Member>(const char *key, Member &member) {
        const Json &value = json.at(Json::json_pointer(key));
        if constexpr (std::is_same_v<Member, int>) {
            member = whole_from<int>(value, key + 1, most_of_a_count);
        } else {
            value.get_to(member);
        }
    });
    WorkPrecision &m = run.measured;
    at("size", [&] { check_size(m.options.size); });
    m.scene = parse_scene(json.at("scene").dump(), "scene", {});
    m.seconds = quantities_from(json.at("seconds"), accounting_quantities);
    for (const Json &mesh : json.at("meshes")) {
        m.meshes.push_back(at(element("meshes", m.meshes.size()), [&] {
            return PlannedMesh{whole_from<int>(mesh.at("rings"), "rings", most_rings),
                               mesh.at("own").get<bool>(),
                               mesh.at("ladder").get<bool>(),
                               whole_from<std::size_t>(mesh.at("triangles"), "triangles", most_triangles),
                               {}};
        }));
    }
    for (const Json &row : json.at("rows")) {
        m.rows.push_back(at(element("rows", m.rows.size()), [&] { return row_from(row, m.meshes.size()); }));
    }
    for (const Json &row : json.at("omitted")) {
        m.omitted.push_back({row.at("technique"), row.at("reason")});
    }
    for (const Json &finding : json.value("precision", Json::array())) { // earlier reports have none
        m.precision.push_back(at(element("precision", m.precision.size()), [&] { return precision_from(finding); }));
    }
    return run;
}

} // namespace

std::string report_json(const std::vector<ReportRun> &runs) {
    Json json{{"format", report_format}, {"runs", Json::array()}};
    for (const ReportRun &run : runs) {
        json["runs"].push_back(run_json(run));
    }
    return json.dump(1) + "\n";
}

std::vector<ReportRun> read_report_json(std::string_view text, std::string_view name) {
    const auto json = read_json<Json>(text, name);
    std::vector<ReportRun> runs;
    try {
        if (!json.is_object() || json.value("format", "") != report_format) {
            throw InputError("expected a report.json of this program (\"format\": \"{}\")", report_format);
        }
        for (const Json &run : json.at("runs")) {
            runs.push_back(at(element("runs", runs.size()), [&] { return run_from(run); }));
        }
        if (runs.empty()) {
            throw InputError("runs: expected one or more");
        }
    } catch (const InputError &error) {
        throw InputError("{}: {}", name, error.what());
    } catch (const Json::exception &error) {
        throw InputError("{}: expected a report.json of this program: {}", name, error.what());
    }
    return runs;
}

} // namespace sandbox
