#include "ui/jobs/measured_rows.h"

#include "measure/report/text.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox {

bool is_current(const WorkPrecision &measured, const Scene &shown) {
    return measured.scene == shown ||
           std::ranges::find(measured.meshes, shown, &PlannedMesh::scene) != measured.meshes.end();
}

std::optional<std::size_t> shown_row(const WorkPrecision &measured, const Document &document, bool right,
                                     std::optional<Model> model) {
    Technique technique = right ? document.right : document.left;
    technique.model = model.value_or(technique.model);
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

std::vector<std::string> row_lines(const Words &words, const WorkPrecision &measured, std::size_t index) {
    const MeasuredRow &row = measured.rows[index];
    const PlannedMesh &mesh = measured.meshes[row.plan.mesh];
    std::vector<std::string> lines{to_string(row.plan.technique),
                                   words.format("row.mesh", mesh_words(words, mesh), mesh.triangles)};
    if (row.time) {
        lines.push_back(words.format("row.time", milliseconds_text(row.time->median),
                                     milliseconds_text(row.time->lower_quartile),
                                     milliseconds_text(row.time->upper_quartile)));
    }
    if (row.errors) {
        std::vector<std::string> errors, parts;
        const std::string &comma = words.text("list.comma");
        for (const ErrorNorm norm : error_norms) {
            errors.push_back(fmt::format("{} {}", title_of(words, norm),
                                         short_number(words, value_of(row.errors->total.norms, norm))));
        }
        for (const ErrorPart &part : error_parts) {
            parts.push_back(
                fmt::format("{} {}", title_of(words, part), short_number(words, part.rmse(row.errors->split))));
        }
        lines.push_back(fmt::format("{}", fmt::join(errors, comma)));
        if (const std::string mark = why_untrusted(words, row.errors->total); !mark.empty()) {
            lines.push_back(mark);
        }
        lines.push_back(words.format("row.parts", fmt::join(parts.begin(), parts.begin() + 2, comma)));
        lines.push_back(fmt::format("{}", fmt::join(parts.begin() + 2, parts.end(), comma)));
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
