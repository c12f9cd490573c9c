#include "ui/jobs/measured_rows.h"

#include "measure/report/text.h"

#include <algorithm>

namespace sandbox {

bool is_current(const WorkPrecision &measured, const Scene &shown) {
    return measured.scene == shown ||
           std::ranges::find(measured.meshes, shown, &PlannedMesh::scene) != measured.meshes.end();
}

std::optional<std::size_t> shown_row(const WorkPrecision &measured, const Document &document, bool right) {
    const Technique &technique = right ? document.right : document.left;
    for (std::size_t mesh = 0; mesh < measured.meshes.size(); ++mesh) {
        if (measured.meshes[mesh].scene == document.scene) {
            return find_row(measured, mesh, technique);
        }
    }
    return std::nullopt;
}

void take_row(Document &document, const WorkPrecision &measured, std::size_t row, bool right) {
    const PlannedRow &plan = measured.rows[row].plan;
    if (is_current(measured, document.scene)) {
        document.scene = measured.meshes[plan.mesh].scene;
    }
    (right ? document.right : document.left) = plan.technique;
}

std::vector<std::string> row_lines(const WorkPrecision &measured, std::size_t index) {
    const MeasuredRow &row = measured.rows[index];
    const PlannedMesh &mesh = measured.meshes[row.plan.mesh];
    std::vector<std::string> lines{to_string(row.plan.technique),
                                   mesh_words(mesh) + ", " + std::to_string(mesh.triangles) + " triangles"};
    if (row.time) {
        lines.push_back(milliseconds_text(row.time->median) + " ms, half of the frames within " +
                        milliseconds_text(row.time->lower_quartile) + " to " +
                        milliseconds_text(row.time->upper_quartile));
    }
    if (row.errors) {
        const Norms &total = row.errors->total.norms;
        const ErrorSplit &split = row.errors->split;
        lines.push_back("RMSE " + short_number(total.rmse) + ", 99th percentile " + short_number(total.p99_abs) +
                        ", largest " + short_number(total.max_abs));
        lines.push_back("RMSE of its parts: interpolation " + short_number(split.interpolation.rmse) + ", geometry " +
                        short_number(split.geometry ? split.geometry->rmse : 0) + ",");
        lines.push_back("float32 " + short_number(split.arithmetic.rmse) + ", rounding to 8 bits " +
                        short_number(split.quantisation.rmse));
    }
    return lines;
}

std::size_t complete_rows(const WorkPrecision &measured) {
    return static_cast<std::size_t>(std::ranges::count_if(measured.rows, &MeasuredRow::complete));
}

std::size_t complete_rounds(const WorkPrecision &measured) {
    std::size_t rounds = static_cast<std::size_t>(measured.options.repeats);
    for (const MeasuredRow &row : measured.rows) {
        if (row.refused.empty()) {
            rounds = std::min(rounds, row.time ? row.time->samples.size() : 0);
        }
    }
    return rounds;
}

} // namespace sandbox
