#include "measure/report/pictures.h"

#include "measure/report/text.h"
#include "measure/work_precision/findings.h"

namespace sandbox {

std::vector<ReportPicture> report_pictures(const WorkPrecision &measured, const DrawRows &draw) {
    const Model model = models_of(measured).back();
    const MeasuredRow *best = nullptr;
    const MeasuredRow *worst = nullptr;
    for (const MeasuredRow &row : measured.rows) {
        const bool base = row.plan.group == RowGroup::ladder || row.plan.group == RowGroup::own_mesh;
        if (!base || !row.finite() || row.plan.technique.model != model) {
            continue;
        }
        const double error = row.errors->total.norms.rmse;
        best = best == nullptr || error < best->errors->total.norms.rmse ? &row : best;
        worst = worst == nullptr || error > worst->errors->total.norms.rmse ? &row : worst;
    }
    const bool analytic = measured.no_analytic_surface.empty();
    std::vector<ReportPicture> pictures;
    const ReferenceFrame truth = report_truth(model, analytic, measured.meshes, measured.options.size, draw.load);
    pictures.push_back({"The truth",
                        std::string(name_of(model)) + " per pixel in double, on the " +
                            (analytic ? "surfaces themselves" : "finest mesh"),
                        to_display(to_frame(truth).color)});
    const auto add = [&](const std::string &title, const MeasuredRow *row) {
        if (row != nullptr) {
            const PlannedMesh &mesh = measured.meshes[row->plan.mesh];
            pictures.push_back({title,
                                to_string(row->plan.technique) + ", " + mesh_words(mesh) + ": RMSE " +
                                    short_number(row->errors->total.norms.rmse),
                                to_display(draw.picture(mesh.scene, row->plan.technique).color)});
        }
    };
    add("Closest to it", best);
    add("Farthest from it", worst);
    return pictures;
}

} // namespace sandbox
