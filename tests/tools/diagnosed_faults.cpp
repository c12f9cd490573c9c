#include "tools/diagnosed_faults.h"

#include "measure/diagnosis/candidates.h"

#include <algorithm>
#include <fmt/format.h>

namespace sandbox {
namespace {

/// "gate=none,viewer=infinite"
std::string settings_of(const Technique &technique) {
    const std::string text = to_string(technique);
    const auto colon = text.find(':');
    return colon == std::string::npos ? "none" : text.substr(colon + 1);
}

double levels_between(const Image &a, const Image &b) {
    const std::vector<std::uint8_t> all(a.pixels.size(), 1);
    return difference_of(shown_levels(a, {}, true), shown_levels(b, {}, true), all, 0).largest;
}

} // namespace

std::vector<FaultyPicture> faulty_pictures(const std::string &scene_name, const Scene &scene, const Technique &base,
                                           std::size_t faults, const DiagnosisDraw &draw, Size size,
                                           std::size_t every) {
    constexpr double visible = 2;
    const auto resources = draw.load(scene);
    const auto image = [&](const Technique &technique) { return draw.picture(scene, technique, size, false).color; };
    std::vector<Image> fewer;
    for (const Candidate &candidate : single_candidates(scene, resources, {base})) {
        if (candidate.faults < faults) {
            fewer.push_back(image(candidate.technique));
        }
    }
    std::vector<FaultyPicture> pictures;
    std::size_t met = 0;
    for (const Candidate &candidate :
         faults == 1 ? single_candidates(scene, resources, {base}) : pair_candidates(scene, resources, {base})) {
        // Other scenes and bases begin elsewhere in their lists.
        if (candidate.faults != faults || (met++ + scene_name.size() + to_string(base).size()) % every != 0) {
            continue;
        }
        const Image drawn = image(candidate.technique);
        if (std::ranges::all_of(fewer, [&](const Image &other) { return levels_between(drawn, other) > visible; })) {
            const ByteImage bytes = to_display(drawn);
            pictures.push_back(
                {scene_name, scene, base, candidate.technique, {from_bytes(bytes.size, bytes.rgb.data(), 3), true}});
        }
    }
    return pictures;
}

Naming naming_of(const Diagnosis &diagnosis, const Technique &truth) {
    if (diagnosis.verdict == Verdict::unknown) {
        return Naming::unknown;
    }
    const bool listed = std::ranges::find(diagnosis.ties, truth) != diagnosis.ties.end();
    if (!diagnosis.conventions.empty() || (diagnosis.technique != truth && !listed)) {
        return Naming::misnamed;
    }
    return diagnosis.ties.empty() ? Naming::named : Naming::tied;
}

void ConfusionTable::add(const FaultyPicture &picture, const Diagnosis &diagnosis) {
    Row &row = rows_[settings_of(picture.truth)];
    ++row.counts[naming_of(diagnosis, picture.truth)];
    if (diagnosis.verdict != Verdict::unknown && diagnosis.technique != picture.truth) {
        std::string name = to_string(diagnosis.technique);
        for (const Convention &convention : diagnosis.conventions) {
            name += " " + convention.name;
        }
        ++row.named_as[name];
    }
}

std::size_t ConfusionTable::count(Naming naming) const {
    std::size_t sum = 0;
    for (const auto &[fault, row] : rows_) {
        const auto found = row.counts.find(naming);
        sum += found == row.counts.end() ? 0 : found->second;
    }
    return sum;
}

std::string ConfusionTable::text() const {
    std::string text = fmt::format("{:<62}{:>6}{:>6}{:>9}{:>10}\n", "fault", "named", "tied", "unknown", "misnamed");
    const auto count_in = [](const Row &row, Naming naming) {
        const auto found = row.counts.find(naming);
        return found == row.counts.end() ? std::size_t{0} : found->second;
    };
    for (const auto &[fault, row] : rows_) {
        text +=
            fmt::format("{:<62}{:>6}{:>6}{:>9}{:>10}\n", fault, count_in(row, Naming::named),
                        count_in(row, Naming::tied), count_in(row, Naming::unknown), count_in(row, Naming::misnamed));
        for (const auto &[name, times] : row.named_as) {
            text += fmt::format("    as {} ({})\n", name, times);
        }
    }
    return text + fmt::format("{:<62}{:>6}{:>6}{:>9}{:>10}\n", "all", count(Naming::named), count(Naming::tied),
                              count(Naming::unknown), count(Naming::misnamed));
}

} // namespace sandbox
