#include "measure/report/text.h"

#include "words/row_words.h"

#include <cmath>

namespace sandbox {

std::string short_number(double value) {
    if (std::isnan(value)) {
        return "none";
    }
    if (!std::isfinite(value)) {
        return "not finite";
    }
    if (value == 0) {
        return "0";
    }
    const double size = std::abs(value);
    if (size < 1e-3 || size >= 1e5) {
        return fmt::format("{:.2e}", value);
    }
    const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : size >= 0.01 ? 4 : 5;
    return fmt::format("{:.{}f}", value, decimals);
}

std::string short_number(const Words &words, double value) {
    return std::isnan(value)       ? words.text("report.none")
           : !std::isfinite(value) ? words.text("difference.not_finite")
                                   : short_number(value);
}

std::string milliseconds_text(double value) {
    return fmt::format("{:.{}f}", value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

std::string mesh_words(const Words &words, const PlannedMesh &mesh) {
    return mesh.ladder ? words.format(mesh.own ? "mesh.own_rings" : "mesh.rings", mesh.rings)
                       : words.text("mesh.scenes_own");
}

std::string short_mesh_words(const Words &words, const PlannedMesh &mesh) {
    return mesh.ladder ? words.format("mesh.rings", mesh.rings) : words.text("mesh.own");
}

namespace {

std::string norm_key(ErrorNorm norm) { return fmt::format("norm.{}", quantity_of(norm).name); }
std::string mask_key(const Mask &mask) { return fmt::format("mask.{}", mask.name); }
std::string part_key(const ErrorPart &part) { return fmt::format("error_part.{}", part.name); }

} // namespace

std::string title_of(const Words &words, ErrorNorm norm) { return row_text(words, norm_key(norm), name_of(norm)); }
std::string long_title_of(const Words &words, ErrorNorm norm) {
    return row_text(words, norm_key(norm) + ".long", quantity_of(norm).meaning);
}
std::string unit_title(const Words &words, std::string_view unit) {
    return unit.empty() ? "" : row_text(words, fmt::format("unit.{}", unit), unit);
}
std::string title_of(const Words &words, const Mask &mask) { return row_text(words, mask_key(mask), mask.name); }
std::string heading_of(const Words &words, const ErrorPart &part) {
    return row_text(words, part_key(part) + ".heading", part.heading);
}
std::string title_of(const Words &words, const ErrorPart &part) {
    return row_text(words, part_key(part), part.meaning);
}

std::string why_untrusted(const Words &words, const Metrics &metrics) {
    if (why_untrusted(metrics).empty()) {
        return {};
    }
    std::size_t shown = metrics.compared_pixels;
    std::vector<std::string> causes;
    for (const Mask &mask : masks) {
        shown += metrics.*mask.pixels;
        if (metrics.*mask.pixels > 0) {
            causes.push_back(fmt::format("{} {}", title_of(words, mask), metrics.*mask.pixels));
        }
    }
    const std::string list = fmt::format("{}", fmt::join(causes, words.text("list.comma")));
    return shown == 0                     ? words.text("untrusted.nothing")
           : metrics.compared_pixels == 0 ? words.format("untrusted.none", shown, list)
                                          : words.format("untrusted", metrics.compared_pixels, shown, list);
}

std::map<std::string, std::string> measured_row_texts() {
    std::map<std::string, std::string> texts;
    for (const ErrorNorm norm : error_norms) {
        texts.emplace(norm_key(norm), name_of(norm));
        texts.emplace(norm_key(norm) + ".long", quantity_of(norm).meaning);
    }
    for (const Mask &mask : masks) {
        texts.emplace(mask_key(mask), mask.name);
    }
    const auto add = [&](const auto &row) {
        texts.emplace(fmt::format("metric.{}", row.name), row.meaning);
        if (!row.unit.empty()) {
            texts.emplace(fmt::format("unit.{}", row.unit), row.unit);
        }
        if (!row.heading.empty()) {
            texts.emplace(fmt::format("metric.{}.heading", row.name), row.heading);
        }
    };
    for_each_metric(Metrics{}, [&](const auto &row, const auto &) { add(row); });
    for (const Quantity<RunTime> &row : run_time_quantities) {
        add(row);
    }
    for (const Quantity<Accounting> &row : accounting_quantities) {
        add(row);
    }
    for (const Quantity<CertificateFigures> &row : certificate_quantities) {
        add(row);
    }
    for (const ErrorPart &part : error_parts) {
        texts.emplace(part_key(part), part.meaning);
        texts.emplace(part_key(part) + ".heading", part.heading);
    }
    return texts;
}

std::string bound_name(double bound) { return bound == 1e-5 ? "1e-5" : fmt::format("1/{}", std::lround(1 / bound)); }

} // namespace sandbox
