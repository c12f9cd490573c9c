#include "measure/diagnosis/diagnosis_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <ranges>

namespace sandbox {
namespace {

using nlohmann::ordered_json;

std::string color_text(const glm::dvec3 &v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }
ordered_json color_json(const glm::dvec3 &v) { return {v.x, v.y, v.z}; }

std::string count_text(std::size_t count, const char *what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string term_name(const TermShare &share, const Scene &scene) {
    if (!share.light) {
        return "the scene's own light";
    }
    return scene.lights.size() == 1 ? std::string(share.term) : fmt::format("lights[{}] {}", *share.light, share.term);
}

/// The terms that differ, as both have them.
std::string terms_text(const Diagnosis &diagnosis, const Scene &scene) {
    constexpr double negligible = 0.5 / 255;
    std::string lines;
    const auto color_in = [](const std::vector<TermShare> &shares, const TermShare &like) {
        const auto found = std::ranges::find_if(
            shares, [&](const TermShare &share) { return share.light == like.light && share.term == like.term; });
        return found == shares.end() ? glm::dvec3(0) : found->color;
    };
    std::vector<TermShare> all = diagnosis.pixel.right_terms;
    for (const TermShare &share : diagnosis.pixel.named_terms) {
        if (color_in(all, share) == glm::dvec3(0)) {
            all.push_back({share.light, share.term, glm::dvec3(0)});
        }
    }
    for (const TermShare &share : all) {
        const glm::dvec3 named = color_in(diagnosis.pixel.named_terms, share);
        const glm::dvec3 by = glm::abs(named - share.color);
        const std::string line = fmt::format("  {:<22} {} instead of {}\n", term_name(share, scene), color_text(named),
                                             color_text(share.color));
        if (std::max({by.x, by.y, by.z}) > negligible && lines.find(line) == std::string::npos) {
            lines += line;
        }
    }
    return lines.empty() ? lines : "Its terms, in linear colour, as explained and as they should be:\n" + lines;
}

std::string settings_text(const Technique &technique) {
    std::string lines;
    for (const TechniqueKey &key : technique_settings) {
        if (const int value = key.get(technique); value != 0 && key.name != "program") {
            lines += fmt::format("  {}={}: {}\n", key.name, key.value(technique).name, key.value(technique).look_for);
        }
    }
    return lines;
}

std::string headline(const Diagnosis &diagnosis) {
    const std::string technique = to_string(diagnosis.technique);
    switch (diagnosis.verdict) {
    case Verdict::right:
        return fmt::format("Right: this is {}; no fault is needed to explain it.\n", technique) +
               (diagnosis.ties.empty() ? "" : "It could have faults that this scene does not show: see below.\n");
    case Verdict::named:
        return fmt::format("This is {}.\n", technique);
    case Verdict::tied:
        return fmt::format("This is {}, or one of {} that cannot be told from it in this picture.\n", technique,
                           count_text(diagnosis.ties.size(), "technique"));
    default:
        return "Nothing known explains this picture.\n";
    }
}

std::string residual_text(const Diagnosis &diagnosis) {
    if (diagnosis.shown_pixels == 0) {
        return "No pixel shows an object: there is nothing to compare.\n";
    }
    const Difference &residual = diagnosis.residual;
    std::string text =
        diagnosis.verdict != Verdict::unknown
            ? fmt::format("It differs from that by at most {:.3g} of 255 levels", residual.largest)
            : fmt::format(
                  "The nearest that is known, {}, differs by up to {:.3g} of 255 levels, by more than one at {:.1f} %",
                  to_string(diagnosis.technique), residual.largest,
                  100 * static_cast<double>(residual.over) / static_cast<double>(residual.compared));
    text += fmt::format(" of the {} compared{}.\n", count_text(residual.compared, "pixel"),
                        diagnosis.masked ? "; edges, jumps and outlines are left out" : "");
    if (diagnosis.verdict != Verdict::unknown) {
        text += residual.largest > tolerated_levels ? "That is the rounding of pow() in a stiff highlight.\n" : "";
        return text.replace(text.find(" of the "), 8, " at the ");
    }
    return text;
}

bool is_right(const Technique &technique) {
    return std::ranges::all_of(technique_settings,
                               [&](const TechniqueKey &key) { return !key.is_fault() || key.get(technique) == 0; });
}

/// `right`: the first picture owes no fault.
std::string second_look_text(const SecondLook &look, bool right) {
    if (!look.error.empty()) {
        return fmt::format("It cannot be drawn there: {}\n", look.error);
    }
    if (look.remaining.empty()) {
        return "Drawn there, it is none of them: it may be made for this scene alone.\n";
    }
    const std::string unseen = !right || std::ranges::any_of(look.remaining, is_right)
                                   ? ""
                                   : "It has a fault, which this scene does not show.\n";
    if (look.remaining.size() == 1) {
        return fmt::format("Drawn there, it is {}.\n", to_string(look.remaining.front())) + unseen;
    }
    std::string text = unseen + "Drawn there, it may still be any of these:\n";
    for (const Technique &technique : look.remaining) {
        text += "  " + to_string(technique) + "\n";
    }
    return text;
}

} // namespace

std::string diagnosis_text(const Diagnosis &diagnosis, const Scene &scene) {
    std::string text = headline(diagnosis);
    const bool known = diagnosis.verdict != Verdict::unknown;
    text += known ? settings_text(diagnosis.technique) : "";
    for (const Convention &convention : diagnosis.conventions) {
        text += fmt::format("  {}{}: {}\n", known ? "" : "nearest with ", convention.name, convention.words);
    }
    text += residual_text(diagnosis);
    if (!diagnosis.ties.empty()) {
        text += "At most one level from it at every compared pixel:\n";
        for (const Technique &tie : diagnosis.ties) {
            text += "  " + to_string(tie) + "\n";
        }
        text += diagnosis.proposal
                    ? fmt::format("Draw {} to tell {} of them from it: there they differ by {:.0f} levels or more.\n",
                                  diagnosis.proposal->arguments, diagnosis.proposal->told.size(),
                                  diagnosis.proposal->levels)
                    : "No scene that was tried tells them apart.\n";
        text += diagnosis.after_proposal
                    ? second_look_text(*diagnosis.after_proposal, diagnosis.verdict == Verdict::right)
                    : "";
    }
    const TellingPixel &pixel = diagnosis.pixel;
    if (diagnosis.shown_pixels > 0 && diagnosis.verdict != Verdict::right) {
        text += fmt::format("Pixel ({}, {}) shows it best: {} in the picture, {} {}, {} if right.\n", pixel.x, pixel.y,
                            color_text(pixel.picture), color_text(pixel.named), known ? "explained" : "in the nearest",
                            color_text(pixel.right));
        text += known ? terms_text(diagnosis, scene) : "";
    }
    return text;
}

std::string diagnosis_json(const Diagnosis &diagnosis, const std::string &scene, const std::string &renderer) {
    const auto number = [](double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(); };
    const auto names = [](const std::vector<Technique> &techniques) {
        ordered_json all = ordered_json::array();
        for (const Technique &technique : techniques) {
            all.push_back(to_string(technique));
        }
        return all;
    };
    const auto terms = [](const std::vector<TermShare> &shares) {
        ordered_json all = ordered_json::array();
        for (const TermShare &share : shares) {
            all.push_back({{"light", share.light ? ordered_json(*share.light) : ordered_json()},
                           {"term", share.term},
                           {"color", color_json(share.color)}});
        }
        return all;
    };
    const bool unknown = diagnosis.verdict == Verdict::unknown;
    const bool something = diagnosis.shown_pixels > 0;
    ordered_json json{{"verdict", verdict_words[static_cast<std::size_t>(diagnosis.verdict)]}};
    const ordered_json technique = something ? ordered_json(to_string(diagnosis.technique)) : ordered_json();
    json["technique"] = unknown ? ordered_json() : technique;
    if (unknown) {
        json["nearest"] = technique;
    }
    json["ties"] = names(diagnosis.ties);
    json["conventions"] = ordered_json::array();
    for (const Convention &convention : diagnosis.conventions) {
        json["conventions"].push_back(convention.name);
    }
    json["residual"] = something ? number(diagnosis.residual.largest) : ordered_json();
    json["residual_rms"] = something ? number(diagnosis.residual.rms) : ordered_json();
    json["residual_pixels"] = diagnosis.residual.over;
    json["compared_pixels"] = diagnosis.residual.compared;
    json["compared_share"] =
        something
            ? number(static_cast<double>(diagnosis.residual.compared) / static_cast<double>(diagnosis.shown_pixels))
            : ordered_json();
    json["masked"] = diagnosis.masked;
    json["pixel"] = ordered_json();
    if (something) {
        const TellingPixel &pixel = diagnosis.pixel;
        json["pixel"] = {{"x", pixel.x},
                         {"y", pixel.y},
                         {"picture", color_json(pixel.picture)},
                         {"expected", color_json(pixel.named)},
                         {"right", color_json(pixel.right)},
                         {"terms", terms(pixel.named_terms)},
                         {"right_terms", terms(pixel.right_terms)}};
    }
    json["proposal"] = ordered_json();
    if (diagnosis.proposal) {
        json["proposal"] = {{"scene", diagnosis.proposal->arguments},
                            {"tells", names(diagnosis.proposal->told)},
                            {"levels", number(diagnosis.proposal->levels)}};
    }
    json["after_proposal"] = ordered_json();
    if (const auto &look = diagnosis.after_proposal) {
        json["after_proposal"] = {{"remaining", names(look->remaining)},
                                  {"error", look->error.empty() ? ordered_json() : ordered_json(look->error)}};
    }
    json["scene"] = scene;
    json["candidates"] = diagnosis.candidates;
    json["renderer"] = renderer;
    return json.dump(2) + "\n";
}

} // namespace sandbox
