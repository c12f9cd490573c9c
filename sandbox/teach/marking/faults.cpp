#include "teach/marking/faults.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sandbox {
namespace {

using enum MarkTerm;
using Kind = ErrorKind;

/// The faults of techniques by key and value, and other people's conventions by how their names begin.
struct NamedFault {
    std::string_view name;
    FaultTerms terms; ///< the first that the exercise asks for pays
    ErrorKind kind;
};
constexpr NamedFault settings[]{
    {"normals=model-matrix", {normals, diffuse}, Kind::shape},
    {"normals=untransformed", {normals, diffuse}, Kind::with_object},
    {"normals=unnormalized", {normals, diffuse}, Kind::too_bright},
    {"normals=cofactor", {normals, diffuse}, Kind::elsewhere},
    {"normals=view-space", {normals, diffuse}, Kind::with_camera},
    {"renormalize=off", {normals, specular, diffuse}, Kind::too_dark},
    {"position=w0", {diffuse, specular}, Kind::elsewhere},
    {"position=absolute", {diffuse, specular}, Kind::shape},
    {"gate=view-facing", {specular}, Kind::unlit_too},
    {"gate=none", {specular}, Kind::unlit_too},
    {"gate=times-n-dot-l", {specular}, Kind::too_dark},
    {"facing=view", {normals, diffuse}, Kind::unlit_too},
    {"viewer=infinite", {specular}, Kind::elsewhere},
    {"half_vector=constant", {specular}, Kind::elsewhere},
    {"ambient=where-lit", {ambient}, Kind::step},
    {"direction=unnegated-diffuse", {diffuse}, Kind::elsewhere},
    {"attenuation=interpolated", {attenuation, diffuse}, Kind::shape},
    {"attenuation=distance-interpolated", {attenuation, diffuse}, Kind::shape},
    {"normalisation=blinn-phong", {specular, diffuse}, Kind::too_bright},
};
constexpr NamedFault conventions_known[]{
    {"display=srgb", {sum}, Kind::too_bright},
    {"display=gamma-2.2", {sum}, Kind::too_bright},
    {"flipped", {sum}, Kind::elsewhere},
    {"clamped", {sum}, Kind::too_dark},
    {"factor=", {sum}, Kind::too_bright},
    {"lights[", {sum}, Kind::too_dark},
    {"attenuation=none", {attenuation, diffuse}, Kind::missing},
    {"cone=none", {cone, diffuse}, Kind::missing},
    {"ambient=attenuated", {attenuation, ambient}, Kind::too_dark},
    {"ambient=unattenuated", {attenuation, ambient}, Kind::too_bright},
    {"ambient=", {ambient}, Kind::too_bright},
    {"diffuse=", {diffuse}, Kind::too_bright},
    {"specular=", {specular}, Kind::too_bright},
    {"exponent=", {specular}, Kind::shape},
};

/// Where the exercise asks for none of them, its last term of light pays, else its first term.
MarkTerm payer(const FaultTerms &wanted, const Exercise &exercise) {
    for (const MarkTerm term : wanted.terms()) {
        if (exercise.find(term) != nullptr) {
            return term;
        }
    }
    MarkTerm last = exercise.terms.front().term;
    for (const LightTerm &row : light_terms) {
        last = exercise.find(row.term) != nullptr ? row.term : last;
    }
    return last;
}

/// What a factor of 0 leaves out.
constexpr std::array<std::string_view, 3> light_words{"ambient", "diffuse", "specular"};

/// The factor that a convention's name ends in: "0.5" of "ambient=0.5".
ErrorKind kind_of_factor(const std::string &value, ErrorKind otherwise) {
    if (value.empty() || value.find_first_not_of("0123456789.e+-") != std::string::npos) {
        return otherwise;
    }
    const double factor = std::stod(value);
    return factor == 0 ? Kind::missing : factor < 1 ? Kind::too_dark : Kind::too_bright;
}

Fault fault_of(const Convention &convention, const Exercise &exercise) {
    const auto *row = std::ranges::find_if(
        conventions_known, [&](const NamedFault &known) { return convention.name.starts_with(known.name); });
    if (row == std::end(conventions_known)) {
        return {payer({sum}, exercise), Kind::shape, "mark.convention.other", {}, convention.name};
    }
    const auto equals = convention.name.find('=');
    const std::string value = equals == std::string::npos ? "" : convention.name.substr(equals + 1);
    const bool exponent = row->name == "exponent=";
    ErrorKind kind = kind_of_factor(value, row->kind);
    if (exponent) {
        kind = kind == Kind::too_bright ? Kind::too_narrow : Kind::too_wide;
    }
    std::string key(row->name.substr(0, row->name.find_last_not_of("=[") + 1));
    std::ranges::replace(key, '=', '.');
    if (kind == Kind::missing && std::ranges::count(light_words, key) != 0) {
        return {payer(row->terms, exercise), kind, fmt::format("mark.fault.{}-missing", key)};
    }
    return {payer(row->terms, exercise), kind, "mark.convention." + key, {}, value};
}

} // namespace

std::vector<Fault> faults_of(const Technique &technique, const std::vector<Convention> &conventions,
                             const Exercise &exercise) {
    std::vector<Fault> faults;
    if (technique.frequency != exercise.target.frequency) {
        faults.push_back({payer({specular, diffuse}, exercise), Kind::shape, "mark.fault.frequency"});
    }
    if (technique.model != exercise.target.model) {
        faults.push_back({payer({specular, diffuse}, exercise), Kind::shape, "mark.fault.model"});
    }
    for (int i = 0; i < static_cast<int>(std::size(technique_settings)); ++i) {
        const TechniqueKey &key = technique_settings[i];
        const std::string setting = fmt::format("{}={}", key.name, key.value(technique).name);
        const auto *row = std::ranges::find(settings, setting, &NamedFault::name);
        if (key.get(technique) != 0 && row != std::end(settings)) {
            faults.push_back({payer(row->terms, exercise), row->kind, {}, {}, {}, i, key.get(technique)});
        }
    }
    for (const Convention &convention : conventions) {
        faults.push_back(fault_of(convention, exercise));
    }
    return faults;
}

} // namespace sandbox
