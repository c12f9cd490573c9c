// report.json: {"format": "shading-sandbox report 1", "runs": [run]}. Errors are of linear colour, times milliseconds.
// run: version, date, quick, scene_name, scene (as a scene file), size, truth ("analytic surface" | "finest mesh"),
//   truth_reason (why not analytic), finished (false: stopped half-way), clock, warm_ups, repeats, first_rings,
//   last_rings, machine {renderer, opengl, processor, threads, llvmpipe_threads, build},
//   seconds {drawing, reference, metrics, other}, meshes [{rings (0: between two rungs), own, ladder, triangles}],
//   rows, omitted [{technique, reason}], findings.
// row: technique, mesh (index), rings, triangles, group, refused (a reason) or
//   errors {nonfinite_pixels, compared_pixels, silhouette_pixels, edge_pixels, jump_pixels, rmse, mean_abs, max_abs,
//   p99_abs, psnr (null: identical), max_levels, differing_share, split {interpolation, geometry, arithmetic,
//   quantisation: each {rmse, mean_abs, max_abs, p99_abs}}} and time {min, lower_quartile, median, upper_quartile,
//   samples}. Errors of a picture with pixels that are not finite are null.
// findings (rows by index): orders [{coarse, fine, max, l2, l1, interpolation {max, l2, l1}, settling}],
//   pareto [{model, norm, rows}], cheapest [{model, norm, bound, row (null: none)}],
//   specialisation and power [{row, base, time_ratio [lower quartile, median, upper quartile]}],
//   claims [{says, row, against, time_ratio, finding}].
#include "measure/report/json_parts.h"

#include "measure/work_precision/findings.h"
#include "scene/scene_file.h"

#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

using Json = nlohmann::ordered_json;

Json order_json(const Orders &orders) {
    const auto number = [](const std::optional<double> &p) { return p ? Json(*p) : Json(); };
    return {{"max", number(orders.max)}, {"l2", number(orders.l2)}, {"l1", number(orders.l1)}};
}

Json orders_json(const WorkPrecision &measured) {
    Json all = Json::array();
    for (const OrderStep &step : convergence_orders(measured)) {
        Json one{{"coarse", step.coarse}, {"fine", step.fine}};
        one.update(order_json(step.total));
        one["interpolation"] = order_json(step.interpolation);
        one["settling"] = name_of(step.settling);
        all.push_back(one);
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
            fronts.push_back(
                {{"model", name_of(model)}, {"norm", name_of(norm)}, {"rows", pareto_front(measured, model, norm)}});
            for (const double bound : error_bounds) {
                const auto row = cheapest(measured, model, norm, bound);
                cheap.push_back({{"model", name_of(model)},
                                 {"norm", name_of(norm)},
                                 {"bound", bound},
                                 {"row", row ? Json(*row) : Json()}});
            }
        }
    }
    Json claims = Json::array();
    for (const Claim &claim : answer_claims(measured)) {
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
            {"power", ratios_json(ratios_to_base(measured, RowGroup::power))},
            {"claims", claims}};
}

Json run_json(const ReportRun &run) {
    const WorkPrecision &m = run.measured;
    Json json{{"version", run.version},
              {"date", run.date},
              {"quick", run.quick},
              {"scene_name", m.scene.name},
              {"scene", Json::parse(scene_text(m.scene))},
              {"size", {m.options.size.width, m.options.size.height}},
              {"truth", m.no_analytic_surface.empty() ? "analytic surface" : "finest mesh"},
              {"truth_reason", m.no_analytic_surface},
              {"finished", m.finished},
              {"clock", run.machine.clock},
              {"warm_ups", m.options.warm_ups},
              {"repeats", m.options.repeats},
              {"first_rings", m.options.first_rings},
              {"last_rings", m.options.last_rings},
              {"machine", report_parts::machine_json(run.machine)},
              {"seconds",
               {{"drawing", m.seconds.drawing},
                {"reference", m.seconds.reference},
                {"metrics", m.seconds.metrics},
                {"other", m.seconds.other}}}};
    json["meshes"] = Json::array();
    for (const PlannedMesh &mesh : m.meshes) {
        json["meshes"].push_back(
            {{"rings", mesh.rings}, {"own", mesh.own}, {"ladder", mesh.ladder}, {"triangles", mesh.triangles}});
    }
    json["rows"] = Json::array();
    for (const MeasuredRow &row : m.rows) {
        json["rows"].push_back(report_parts::row_json(row, m.meshes));
    }
    json["omitted"] = Json::array();
    for (const OmittedRow &row : m.omitted) {
        json["omitted"].push_back({{"technique", row.technique}, {"reason", row.reason}});
    }
    json["findings"] = findings_json(m);
    return json;
}

} // namespace

std::string report_json(const std::vector<ReportRun> &runs) {
    Json json{{"format", report_parts::format}, {"runs", Json::array()}};
    for (const ReportRun &run : runs) {
        json["runs"].push_back(run_json(run));
    }
    return json.dump(1) + "\n";
}

} // namespace sandbox
