#include "ui/session/pixel_findings.h"

#include "capture/picture.h"
#include "image/error.h"
#include "scene/light_kind.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <glm/common.hpp>

namespace sandbox {

namespace {

constexpr double one_level = 1.0 / 255;

std::string number(double value) { return fmt::format("{:.4g}", value); }
std::string vector(const glm::dvec3 &v) { return fmt::format("{:.3f} {:.3f} {:.3f}", v.x, v.y, v.z); }

/// Empty where the technique has no such vector.
std::string if_any(const glm::dvec3 &v) { return v == glm::dvec3(0) ? "" : vector(v); }

const TermShare *same_term(const std::vector<TermShare> &shares, const TermShare &wanted) {
    const auto found = std::ranges::find_if(
        shares, [&](const TermShare &s) { return s.light == wanted.light && s.term == wanted.term; });
    return found == shares.end() ? nullptr : &*found;
}

const reference::LightTerms *terms_of(const ProbedPixel &side, std::size_t light) {
    const auto found = std::ranges::find(side.probe.lights, light, &reference::LightProbe::light);
    return found == side.probe.lights.end() ? nullptr : &found->terms;
}

using Value = std::function<std::string(const ProbedPixel &)>;
/// A text of all languages as one that scripts know.
template <class... T> Label label(const Words &words, std::string_view key, const T &...values) {
    return {words.format(key, values...), words.english().format(key, values...)};
}

void add_row(std::vector<ProbeRow> &rows, const PixelFindings &found, Label title, const Value &value) {
    ProbeRow row{std::move(title), {}};
    for (const Probed side : all_probed) {
        row.values[static_cast<std::size_t>(side)] = found[side] ? value(*found[side]) : "";
    }
    rows.push_back(std::move(row));
}

/// What the equation meets of one light, then what the light adds.
void add_light(std::vector<ProbeRow> &rows, const Words &words, const PixelFindings &found, std::size_t light) {
    using reference::LightTerms;
    const auto row = [&](std::string_view title, const std::function<std::string(const LightTerms &)> &value) {
        add_row(rows, found, label(words, title, light + 1), [&](const ProbedPixel &side) {
            const LightTerms *terms = terms_of(side, light);
            return terms != nullptr ? value(*terms) : "";
        });
    };
    const Light &lamp = found.of.scene.lights[light];
    const bool highlight = found.of.left.model != Model::lambert || found.of.right.model != Model::lambert;
    row("probe.light.l", [](const LightTerms &t) { return vector(t.vectors.l); });
    row("probe.light.n_dot_l", [](const LightTerms &t) { return number(t.n_dot_l); });
    if (kind_of(lamp.type).positional) {
        row("probe.light.attenuation", [](const LightTerms &t) { return number(t.vectors.a); });
    }
    if (kind_of(lamp.type).conical) {
        row("probe.light.cone", [](const LightTerms &t) { return number(t.s); });
    }
    if (highlight) {
        if (found.of.left.model == Model::phong || found.of.right.model == Model::phong) {
            row("probe.light.r", [](const LightTerms &t) { return if_any(t.vectors.r); });
        }
        if (found.of.left.model == Model::blinn_phong || found.of.right.model == Model::blinn_phong) {
            row("probe.light.h", [](const LightTerms &t) { return if_any(t.vectors.h); });
        }
        row("probe.light.f", [](const LightTerms &t) { return number(t.f); });
        row("probe.light.power", [](const LightTerms &t) { return number(t.f_power); });
    }
    for (const std::string_view term : {"ambient", "diffuse", "specular"}) {
        add_row(rows, found, label(words, fmt::format("probe.light.{}", term), light + 1),
                [&](const ProbedPixel &side) {
                    const TermShare *share = same_term(side.shares, {light, term, {}});
                    return share != nullptr ? vector(share->color) : std::string("0");
                });
    }
}

} // namespace

PixelFindings probe_sides(const SidesShown &shown, const SideResources &resources, int x, int y) {
    PixelFindings found{shown, x, y, {}};
    const std::array scenes{shown.scene_of(false), shown.scene_of(true)};
    const auto probe = [&](bool right, const Technique &technique) -> std::optional<ProbedPixel> {
        const Scene &scene = scenes[right ? 1 : 0];
        const auto &own = resources[right ? 1 : 0];
        try {
            const auto at = probe_pixel(scene, own, technique, shown.size, x, y);
            return at ? std::optional(ProbedPixel{*at, term_shares(scene, own, technique, shown.size, x, y)})
                      : std::nullopt;
        } catch (const InputError &) {
            return std::nullopt; // the view says why
        }
    };
    found.sides = {probe(false, shown.left), probe(true, shown.right), probe(false, shown.truth_of_side(false)),
                   std::nullopt};
    found.sides[3] = shown.one_truth() ? found.sides[2] : probe(true, shown.truth_of_side(true));
    return found;
}

std::string worst_term(const Words &words, const ProbedPixel &side, const ProbedPixel &truth) {
    double most = one_level;
    std::string text;
    for (const TermShare &right : truth.shares) {
        const TermShare *own = same_term(side.shares, right);
        const glm::dvec3 is = own != nullptr ? own->color : glm::dvec3(0);
        const glm::dvec3 apart = glm::abs(is - right.color);
        const int channel = apart.g > apart.r && apart.g >= apart.b ? 1 : apart.b > apart.r ? 2 : 0;
        if (apart[channel] >= most) {
            most = apart[channel];
            const std::string whose = right.light ? words.format("probe.term", *right.light + 1,
                                                                 words.text(fmt::format("term.{}", right.term)))
                                                  : words.text("probe.scene_ambient");
            constexpr std::array channels{"channel.red", "channel.green", "channel.blue"};
            text = words.format("probe.worst", whose, words.text(channels[static_cast<std::size_t>(channel)]),
                                is[channel], right.color[channel]);
        }
    }
    return text;
}

std::vector<ProbeRow> probe_rows(const Words &words, const PixelFindings &found) {
    std::vector<ProbeRow> rows;
    add_row(rows, found, label(words, "probe.colour"),
            [](const ProbedPixel &side) { return vector(side.probe.color); });
    add_row(rows, found, label(words, "probe.position"),
            [](const ProbedPixel &side) { return vector(side.probe.position); });
    add_row(rows, found, "N", [](const ProbedPixel &side) { return vector(side.probe.normal); });
    add_row(rows, found, "V", [](const ProbedPixel &side) { return vector(side.probe.view); });
    add_row(rows, found, label(words, "probe.scene_light"), [](const ProbedPixel &side) {
        return side.shares.empty() ? std::string() : vector(side.shares.front().color);
    });
    for (std::size_t light = 0; light < found.of.scene.lights.size(); ++light) {
        if (found.of.scene.lights[light].enabled) {
            add_light(rows, words, found, light);
        }
    }
    return rows;
}

std::string probe_text(const Words &words, const PixelFindings &found) {
    std::string text = words.format("probe.title", found.x, found.y, found.of.size.width, found.of.size.height,
                                    to_string(found.of.left), to_string(found.of.right)) +
                       "\n";
    for (const ProbeRow &row : probe_rows(words, found)) {
        text += fmt::format("{}\t{}\n", row.title.shown, fmt::join(row.values, "\t"));
    }
    return text;
}

} // namespace sandbox
