#include "measure/report/json_parts.h"

#include "image/error.h"
#include "measure/work_precision/findings.h"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace sandbox::report_parts {
namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no infinity: null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }
double number_from(const Json &json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

Json norms_json(const Norms &norms) {
    return {{"rmse", number(norms.rmse)},
            {"mean_abs", number(norms.mean_abs)},
            {"max_abs", number(norms.max_abs)},
            {"p99_abs", number(norms.p99_abs)}};
}
Norms norms_from(const Json &json) {
    return {number_from(json.at("rmse")), number_from(json.at("mean_abs")), number_from(json.at("max_abs")),
            number_from(json.at("p99_abs"))};
}

Json errors_json(const RowErrors &errors) {
    const Metrics &total = errors.total;
    Json json{{"nonfinite_pixels", total.nonfinite_pixels},
              {"compared_pixels", total.compared_pixels},
              {"silhouette_pixels", total.silhouette_pixels},
              {"edge_pixels", total.edge_pixels},
              {"jump_pixels", total.jump_pixels}};
    json.update(norms_json(total.norms));
    json["psnr"] = total.psnr ? number(*total.psnr) : Json();
    json["max_levels"] = total.max_levels;
    json["differing_share"] = total.differing_share;
    json["split"] = {{"interpolation", norms_json(errors.split.interpolation)},
                     {"geometry", errors.split.geometry ? norms_json(*errors.split.geometry) : Json()},
                     {"arithmetic", norms_json(errors.split.arithmetic)},
                     {"quantisation", norms_json(errors.split.quantisation)}};
    return json;
}

RowErrors errors_from(const Json &json) {
    RowErrors errors;
    Metrics &total = errors.total;
    json.at("nonfinite_pixels").get_to(total.nonfinite_pixels);
    json.at("compared_pixels").get_to(total.compared_pixels);
    json.at("silhouette_pixels").get_to(total.silhouette_pixels);
    json.at("edge_pixels").get_to(total.edge_pixels);
    json.at("jump_pixels").get_to(total.jump_pixels);
    total.norms = norms_from(json);
    if (!json.at("psnr").is_null()) {
        total.psnr = json.at("psnr").get<double>();
    }
    json.at("max_levels").get_to(total.max_levels);
    json.at("differing_share").get_to(total.differing_share);
    const Json &split = json.at("split");
    errors.split.interpolation = norms_from(split.at("interpolation"));
    if (!split.at("geometry").is_null()) {
        errors.split.geometry = norms_from(split.at("geometry"));
    }
    errors.split.arithmetic = norms_from(split.at("arithmetic"));
    errors.split.quantisation = norms_from(split.at("quantisation"));
    return errors;
}

RowGroup group_from(const std::string &name) {
    constexpr std::array groups{RowGroup::ladder, RowGroup::own_mesh, RowGroup::full_program, RowGroup::power,
                                RowGroup::claim};
    for (const RowGroup group : groups) {
        if (name_of(group) == name) {
            return group;
        }
    }
    throw InputError("group: unknown value '" + name + "'");
}

} // namespace

Json machine_json(const Machine &machine) {
    return {{"renderer", machine.renderer},
            {"opengl", machine.opengl},
            {"processor", machine.processor},
            {"threads", machine.threads},
            {"llvmpipe_threads", machine.llvmpipe_threads},
            {"build", machine.build}};
}

Machine machine_from(const Json &json) {
    return {json.at("renderer"),
            json.at("opengl"),
            json.at("processor"),
            json.at("threads").get<int>(),
            json.at("llvmpipe_threads"),
            json.at("build"),
            {}};
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
    }
    if (row.time) {
        json["time"] = {{"min", row.time->min},
                        {"lower_quartile", row.time->lower_quartile},
                        {"median", row.time->median},
                        {"upper_quartile", row.time->upper_quartile},
                        {"samples", row.time->samples}};
    }
    return json;
}

MeasuredRow row_from(const Json &json) {
    MeasuredRow row;
    row.plan.technique = parse_technique(json.at("technique").get<std::string>());
    json.at("mesh").get_to(row.plan.mesh);
    row.plan.group = group_from(json.at("group"));
    row.refused = json.value("refused", "");
    if (json.contains("errors")) {
        row.errors = errors_from(json.at("errors"));
    }
    if (json.contains("time") && !json.at("time").at("samples").empty()) {
        row.time = run_time(json.at("time").at("samples").get<std::vector<double>>());
    }
    return row;
}

} // namespace sandbox::report_parts
