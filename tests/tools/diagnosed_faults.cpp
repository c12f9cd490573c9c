#include "tools/diagnosed_faults.h"

#include "measure/diagnosis/candidates.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <utility>

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

/// Levels.
constexpr double visible = 2;

} // namespace

Observed drawn_as_bytes(const DiagnosisDraw &draw, const Scene &scene, const Technique &technique, Size size) {
    const ByteImage bytes = to_display(draw.picture(scene, technique, size, false).color);
    return {from_bytes(bytes.size, bytes.rgb.data(), 3), true};
}

std::vector<FaultyPicture> faulty_pictures(const std::string &scene_name, const Scene &scene, const Technique &base,
                                           std::size_t faults, const DiagnosisDraw &draw, Size size,
                                           std::size_t every) {
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
            pictures.push_back({scene_name,
                                scene,
                                base,
                                candidate.technique,
                                {},
                                drawn_as_bytes(draw, scene, candidate.technique, size)});
        }
    }
    return pictures;
}

std::vector<FaultyPicture> unconventional_pictures(const std::string &scene_name, const Scene &scene,
                                                   const Technique &base, const DiagnosisDraw &draw, Size size,
                                                   std::size_t every) {
    std::vector<std::pair<Edit, Reading>> ways;
    for (const Reading &reading : all_readings(true)) {
        if (!conventions_of(reading).empty()) {
            ways.push_back({{scene, {}}, reading});
        }
    }
    for (Edit &edit : scene_edits(scene)) {
        ways.push_back({std::move(edit), {}});
    }
    for (const LinearParts &parts : linear_parts(scene)) {
        for (std::size_t i = 0; i < parts.names.size(); ++i) {
            for (const double factor : {0.0, 0.7, 2.0}) {
                std::vector<double> factors(parts.names.size(), 1);
                factors[i] = factor;
                ways.push_back({with_factors(scene, parts, factors), {}});
            }
        }
    }
    ways.push_back({with_exponents(scene, 0.5), {}});
    std::vector<FaultyPicture> pictures;
    std::size_t met = scene_name.size() + to_string(base).size();
    for (const FaultyPicture &plain : faulty_pictures(scene_name, scene, base, 1, draw, size)) {
        for (const auto &[edit, reading] : ways) {
            if (met++ % every != 0) {
                continue;
            }
            FaultyPicture picture = plain;
            const Image drawn = draw.picture(edit.scene, plain.truth, size, false).color;
            const Levels levels = shown_levels(drawn, reading, true);
            const std::vector<std::uint8_t> all(drawn.pixels.size(), 1);
            // Another way may draw the same: all light weaker, and the only light weaker.
            const bool is_first = std::ranges::none_of(ways, [&, &edit = edit, &reading = reading](const auto &way) {
                return &way.first < &edit && way.second == reading &&
                       levels_between(drawn, draw.picture(way.first.scene, plain.truth, size, false).color) <= 1;
            });
            const auto differs = [&](const Levels &other) {
                return difference_of(levels, other, all, 0).largest > visible;
            };
            if (!is_first || !differs(shown_levels(draw.picture(edit.scene, base, size, false).color, reading, true)) ||
                !differs(observed_levels(plain.observed, {}))) {
                continue;
            }
            for (const auto &told : {conventions_of(reading), edit.conventions}) {
                std::ranges::transform(told, std::back_inserter(picture.conventions), &Convention::name);
            }
            for (std::size_t i = 0; i < levels.size(); ++i) {
                const std::size_t row = i / 3 / static_cast<std::size_t>(size.width);
                const std::size_t column = i / 3 % static_cast<std::size_t>(size.width);
                const std::size_t to = reading.flipped ? static_cast<std::size_t>(size.height) - 1 - row : row;
                picture.observed.numbers.pixels[to * static_cast<std::size_t>(size.width) + column][int(i % 3)] =
                    levels[i] / 255;
            }
            pictures.push_back(std::move(picture));
        }
    }
    return pictures;
}

std::string truth_of(const FaultyPicture &picture) {
    return fmt::format("{} {}", to_string(picture.truth), fmt::join(picture.conventions, " "));
}

std::string name_of(const Diagnosis &diagnosis) {
    std::string name = to_string(diagnosis.technique);
    for (const Convention &convention : diagnosis.conventions) {
        name += " " + convention.name;
    }
    return name;
}

Naming naming_of(const Diagnosis &diagnosis, const FaultyPicture &picture) {
    if (diagnosis.verdict == Verdict::unknown) {
        return Naming::unknown;
    }
    const bool listed = std::ranges::find(diagnosis.ties, picture.truth) != diagnosis.ties.end();
    if (!std::ranges::equal(diagnosis.conventions, picture.conventions, {}, &Convention::name) ||
        (diagnosis.technique != picture.truth && !listed)) {
        return Naming::misnamed;
    }
    return diagnosis.ties.empty() ? Naming::named : Naming::tied;
}

void ConfusionTable::add(const FaultyPicture &picture, const Diagnosis &diagnosis) {
    std::string settings = settings_of(picture.truth);
    for (const std::string &convention : picture.conventions) {
        settings += " " + convention;
    }
    Row &row = rows_[settings];
    const Naming naming = naming_of(diagnosis, picture);
    ++row.counts[naming];
    const auto &look = diagnosis.after_proposal;
    row.told += naming == Naming::tied && look && look->remaining == std::vector{picture.truth} ? 1 : 0;
    if (diagnosis.verdict != Verdict::unknown && (diagnosis.technique != picture.truth || naming == Naming::misnamed)) {
        ++row.named_as[name_of(diagnosis)];
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
    const auto line = [](const std::string &name, const auto &...columns) {
        return fmt::format("{:<62}", name) + (fmt::format("{:>11}", columns) + ...) + "\n";
    };
    std::string text = line("fault", "named", "tied", "then told", "unknown", "misnamed");
    std::size_t told = 0;
    for (const auto &[fault, row] : rows_) {
        const auto count_in = [&row = row](Naming naming) {
            const auto found = row.counts.find(naming);
            return found == row.counts.end() ? std::size_t{0} : found->second;
        };
        told += row.told;
        text += line(fault, count_in(Naming::named), count_in(Naming::tied), row.told, count_in(Naming::unknown),
                     count_in(Naming::misnamed));
        for (const auto &[name, times] : row.named_as) {
            text += fmt::format("    as {} ({})\n", name, times);
        }
    }
    const std::size_t named = count(Naming::named);
    const std::size_t all = named + count(Naming::tied) + count(Naming::unknown) + count(Naming::misnamed);
    text += line("all", named, count(Naming::tied), told, count(Naming::unknown), count(Naming::misnamed));
    return text + fmt::format("unique: {:.1f} %, with the proposed scene {:.1f} %\n",
                              100 * static_cast<double>(named) / static_cast<double>(all),
                              100 * static_cast<double>(named + told) / static_cast<double>(all));
}

} // namespace sandbox
