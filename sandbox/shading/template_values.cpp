#include "shading/template_values.h"

#include "shading/needs.h"

#include <utility>

namespace sandbox {
namespace {

/// Terms joined into one GLSL expression; `none` where there are none.
std::string join(const std::vector<std::string> &terms, const std::string &separator, const std::string &none = "") {
    std::string text;
    for (const auto &term : terms) {
        text += (text.empty() ? "" : separator) + term;
    }
    return text.empty() ? none : text;
}

std::string in_brackets(const std::vector<std::string> &terms) {
    return terms.size() > 1 ? "(" + join(terms, " + ") + ")" : join(terms, " + ");
}

/// The lights of one type, seen from one stage.
struct LightPart {
    std::string kind;        ///< "point"
    std::string struct_name; ///< "PointLight"
    const LightFeatures &features;
    const LightNeeds &here;     ///< in this stage
    const LightNeeds &vertex;   ///< in the vertex stage
    const LightNeeds &fragment; ///< in the fragment stage
};

std::string attenuation_denominator(const LightFeatures &f, const std::string &light) {
    std::vector<std::string> terms;
    if (f.constant) {
        terms.push_back(light + ".constant");
    }
    if (f.linear) {
        terms.push_back(light + ".linear * d");
    }
    if (f.quadratic) {
        terms.push_back(light + ".quadratic * d * d");
    }
    return join(terms, " + ", "1.0");
}

std::string highlight(const Features &f, const LightPart &light) {
    if (f.exponent == Exponent::zero) {
        return "1.0";
    }
    if (f.model == Model::phong) {
        return light.here.given_R ? "phong(normalize(mirrored), V)" : "phong(R, L)";
    }
    if (light.features.given_half_vector) {
        return "blinn_phong(N, light.half_vector)";
    }
    return light.here.given_H ? "blinn_phong(N, H)" : "blinn_phong(N, L + V)";
}

/// What a light function is handed besides the light: parameter and argument, in step.
std::pair<std::string, std::string> light_parameters(const LightPart &light, const StageNeeds &stage) {
    const LightNeeds &n = light.here;
    const std::string index = light.features.count > 1 ? "[i]" : "[0]";
    const std::string varying = "v_" + light.kind + "_";
    std::string parameters;
    std::string arguments;
    const auto add = [&](bool needed, const std::string &parameter, const std::string &argument) {
        parameters += needed ? ", " + parameter : "";
        arguments += needed ? ", " + argument : "";
    };
    add(n.finds_L || n.finds_distance, "vec3 P", "P");
    add(n.uses_N, "vec3 N", "N");
    add(n.uses_V, "vec3 V", "V");
    add(n.uses_R, "vec3 R", "R");
    add(n.given_L, "vec3 direction", varying + "L" + index);
    add(n.given_H, "vec3 H", varying + "H" + index);
    add(n.given_R, "vec3 mirrored", varying + "R" + index);
    add(n.given_distance, "float d", varying + "distance" + index);
    add(n.given_attenuation, "float a", varying + "attenuation" + index);
    add(stage.separate_specular && n.adds_specular, "inout vec3 specular", "specular");
    return {parameters, arguments};
}

/// The light's terms: what is added outright, and what attenuation and cone multiply.
void add_sums(TemplateValues &values, const Features &f, const StageNeeds &stage, const LightPart &light) {
    const LightNeeds &n = light.here;
    std::vector<std::string> strength;
    if (light.features.attenuated() && n.fades) {
        strength.emplace_back("a");
    }
    if (n.uses_cone) {
        strength.emplace_back("s");
    }
    const std::string times = strength.empty() ? "" : join(strength, " * ") + " * ";
    const std::string lit = f.where_lit ? "lit * " : "";
    std::vector<std::string> faded;
    if (n.adds_attenuated_ambient) {
        faded.push_back(lit + "light.attenuated_ambient");
    }
    if (n.adds_diffuse) {
        const bool fault = f.unnegated_diffuse && light.kind == "directional";
        faded.push_back(std::string("light.diffuse * max(") + (fault ? "-" : "") + "n_dot_l, 0.0)");
    }
    const std::string specular = "light.specular * highlight";
    if (n.adds_specular && !stage.separate_specular) {
        faded.push_back(specular);
    }
    std::vector<std::string> sum;
    if (n.adds_ambient) {
        sum.push_back(lit + "light.ambient");
    }
    if (!faded.empty()) {
        sum.push_back(times.empty() ? join(faded, " + ") : times + in_brackets(faded));
    }
    values.texts[light.kind + ".sum"] = join(sum, " + ", "vec3(0.0)");
    values.texts[light.kind + ".specular_sum"] = times.empty() ? specular : times + "(" + specular + ")";
}

void add_light(TemplateValues &values, const Features &f, const StageNeeds &stage, const LightPart &light,
               bool vertex) {
    const LightFeatures &has = light.features;
    const LightNeeds &n = light.here;
    const LightNeeds &handed = light.fragment;
    const bool positional = light.kind != "directional";
    const bool varying_any =
        handed.given_L || handed.given_H || handed.given_R || handed.given_distance || handed.given_attenuation;
    const std::string k = light.kind + ".";
    const std::string uniform = has.count > 1 ? light.kind + "_lights[i]" : "the_" + light.kind + "_light";
    const auto [parameters, arguments] = light_parameters(light, stage);
    for (const auto &[name, on] : std::initializer_list<std::pair<const char *, bool>>{
             {"declared", n.any || (vertex && varying_any)},
             {"many", has.count > 1},
             {"positional", positional},
             {"directed", light.vertex.uses_L || light.fragment.uses_L || !positional || n.uses_cone},
             {"ambient", has.ambient},
             {"attenuated_ambient", has.attenuated_ambient},
             {"diffuse", has.diffuse},
             {"specular", has.specular},
             {"given_half_vector", has.given_half_vector},
             {"constant", has.constant},
             {"linear", has.linear},
             {"quadratic", has.quadratic},
             {"floor", has.floor},
             {"on_surface", has.on_surface},
             {"narrow_cone", has.narrow_cone},
             {"hard_cone", has.hard_cone},
             {"soft_cone", has.soft_cone},
             {"cone", has.hard_cone || has.soft_cone},
             {"exponent", has.exponent},
             {"no_exponent", has.no_exponent},
             {"stable_exponent", has.stable_exponent},
             {"adds_ambient", n.adds_ambient},
             {"adds_attenuated_ambient", n.adds_attenuated_ambient},
             {"adds_specular", n.adds_specular},
             {"adds_separate_specular", n.adds_specular && stage.separate_specular},
             {"uses_n_dot_l", n.uses_n_dot_l},
             {"uses_L", n.uses_L},
             {"finds_L", n.finds_L},
             {"given_L", n.given_L},
             {"finds_distance", n.finds_distance},
             {"finds_attenuation", n.finds_attenuation},
             {"uses_cone", n.uses_cone},
             {"varying_L", handed.given_L},
             {"varying_H", handed.given_H},
             {"varying_R", handed.given_R},
             {"varying_distance", handed.given_distance},
             {"varying_attenuation", handed.given_attenuation},
             {"varying_any", varying_any}}) {
        values.flags[k + name] = on;
    }
    if (positional) {
        values.flags[k + "directed"] = light.kind == "spot";
    }
    values.flags["stage." + light.kind] = n.any;
    const std::string denominator = attenuation_denominator(has, uniform);
    values.texts[k + "kind"] = light.kind;
    values.texts[k + "struct"] = light.struct_name;
    values.texts[k + "count"] = std::to_string(has.count);
    values.texts[k + "uniform"] = uniform;
    values.texts[k + "parameters"] = parameters;
    values.texts[k + "arguments"] = arguments;
    values.texts[k + "denominator"] = attenuation_denominator(has, "light");
    values.texts[k + "safe_denominator"] = has.floor ? "max(" + denominator + ", 1e-6)" : "(" + denominator + ")";
    values.texts[k + "distance"] = n.finds_distance ? "d" : "length(to_light)";
    values.texts[k + "highlight"] = highlight(f, light);
    add_sums(values, f, stage, light);
}

void add_stage(TemplateValues &values, const Features &f, const StageNeeds &stage, const std::string &name) {
    const std::string k = name + ".";
    for (const auto &[flag, on] : std::initializer_list<std::pair<const char *, bool>>{
             {"lit", stage.lit},
             {"P", stage.P},
             {"N", stage.N},
             {"V", stage.V},
             {"R", stage.R},
             {"specular", stage.specular},
             {"separate_specular", stage.separate_specular},
             {"constant_ambient", stage.constant_ambient},
             {"uses_view_direction", stage.V && f.viewer == Viewer::infinite},
             {"stable_power", (stage.specular && f.exponent == Exponent::stable) ||
                                  (stage.spot.uses_cone && f.spot.stable_exponent)}}) {
        values.flags[k + flag] = on;
    }
    std::vector<std::string> parameters;
    std::vector<std::string> arguments;
    const auto add = [&](bool needed, const std::string &parameter, const std::string &argument) {
        if (needed) {
            parameters.push_back(parameter);
            arguments.push_back(argument);
        }
    };
    const auto from_point = [](const LightNeeds &n) { return n.finds_L || n.finds_distance; };
    const bool uses_P = from_point(stage.directional) || from_point(stage.point) || from_point(stage.spot);
    const bool uses_V = stage.R || stage.directional.uses_V || stage.point.uses_V || stage.spot.uses_V;
    add(uses_P, "vec3 P", name == "fragment" && !f.wide ? "v_position" : "P");
    add(stage.N, "vec3 N", "N");
    add(uses_V, "vec3 V", "V");
    add(stage.separate_specular, "inout vec3 specular", name == "fragment" ? "specular" : "v_specular");
    values.texts[k + "surface_parameters"] = join(parameters, ", ");
    values.texts[k + "surface_arguments"] = join(arguments, ", ");
    values.texts[k + "first_sum"] = stage.constant_ambient ? "ambient" : "vec3(0.0)";
    values.texts[k + "before_base"] = f.base == Base::none ? "" : ", before the base colour multiplies it";
}

/// The fragment's colour, as one expression.
std::string color_expression(const Features &f, const ProgramNeeds &needs) {
    std::vector<std::string> multiplied;
    std::vector<std::string> plain;
    if (needs.vertex.lit) {
        multiplied.emplace_back("v_light");
    }
    if (needs.fragment.lit) {
        const bool unmodulated = needs.vertex.lit && f.base != Base::none && !f.base_times_specular;
        (unmodulated ? plain : multiplied).emplace_back("light");
    } else if (needs.fragment.constant_ambient) {
        multiplied.emplace_back("ambient");
    }
    if (needs.vertex.separate_specular || needs.fragment.separate_specular) {
        plain.emplace_back(needs.vertex.separate_specular ? "v_specular" : "specular");
    }
    if (f.emission) {
        plain.emplace_back("emission");
    }
    if (f.base != Base::none && !multiplied.empty()) {
        plain.insert(plain.begin(), "base * " + in_brackets(multiplied));
    } else {
        plain.insert(plain.begin(), multiplied.begin(), multiplied.end());
    }
    return join(plain, " + ", "vec3(0.0)");
}

} // namespace

TemplateValues specialised_values(const Features &f, Stage which) {
    const ProgramNeeds needs = derive_needs(f);
    const bool vertex = which == Stage::vertex;
    const StageNeeds &stage = vertex ? needs.vertex : needs.fragment;
    TemplateValues values;
    for (const auto &[name, on] : std::initializer_list<std::pair<const char *, bool>>{
             {"flat", f.frequency == Frequency::flat && needs.vertex.lit},
             {"vectors", needs.vectors},
             {"texture", f.base == Base::texture},
             {"checker", f.base == Base::checker},
             {"emission", f.emission},
             {"object_ids", f.object_ids},
             {"deep", f.deep},
             {"wide", f.wide},
             {"rigid", f.normal_transform == NormalTransform::rigid},
             {"normal_matrix", f.normal_transform == NormalTransform::normal_matrix},
             {"model_matrix_normals", f.normal_transform == NormalTransform::model_matrix},
             {"untransformed_normals", f.normal_transform == NormalTransform::untransformed},
             {"renormalize", f.renormalize},
             {"guard_normal", f.guard_normal},
             {"guard_vertex_normal", f.guard_vertex_normal},
             {"w0", f.position == LightingPosition::w0},
             {"viewer_infinite", f.viewer == Viewer::infinite},
             {"two_sided", f.two_sided},
             {"where_lit", f.where_lit},
             {"phong", f.model == Model::phong && f.exponent != Exponent::zero},
             {"blinn_phong", f.model == Model::blinn_phong && f.exponent != Exponent::zero},
             {"uniform_exponent", f.exponent == Exponent::textbook || f.exponent == Exponent::stable},
             {"exponent_one", f.exponent == Exponent::one},
             {"exponent_stable", f.exponent == Exponent::stable},
             {"gate_light_facing", f.gate == Gate::light_facing},
             {"gate_view_facing", f.gate == Gate::view_facing}}) {
        values.flags[name] = on;
    }
    values.texts["way"] = vertex ? "out" : "in";
    values.texts["flat"] = values.flags["flat"] ? "flat " : "";
    values.texts["vertex.point"] = values.flags["flat"] ? "a_centroid" : "a_position";
    values.texts["fragment.color"] = color_expression(f, needs);
    add_stage(values, f, needs.vertex, "vertex");
    add_stage(values, f, needs.fragment, "fragment");
    add_stage(values, f, stage, "stage");
    if (!vertex) {
        values.texts["stage.surface_arguments"] = values.texts["fragment.surface_arguments"];
    }
    const auto part = [&](const char *kind, const char *name, const LightFeatures &features, auto member) {
        add_light(values, f, stage, {kind, name, features, stage.*member, needs.vertex.*member, needs.fragment.*member},
                  vertex);
    };
    part("directional", "DirectionalLight", f.directional, &StageNeeds::directional);
    part("point", "PointLight", f.point, &StageNeeds::point);
    part("spot", "SpotLight", f.spot, &StageNeeds::spot);
    values.flags["vertex.declares_lights"] =
        values.flags["directional.declared"] || values.flags["point.declared"] || values.flags["spot.declared"];
    return values;
}

} // namespace sandbox
