#include "shading/template_values.h"

#include "shading/own_template.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandbox {
namespace {
using Flags = std::initializer_list<std::pair<std::string_view, bool>>;
using Texts = std::initializer_list<std::pair<std::string_view, std::string>>;

/// The kind "point" makes "point.diffuse" of "diffuse".
std::string dotted(std::string_view kind, std::string_view name) { return std::string(kind).append(".").append(name); }

void add_flags(TemplateValues &values, std::string_view kind, const Flags &flags) {
    for (const auto &[name, on] : flags) {
        values.flags[dotted(kind, name)] = on;
    }
}

void add_texts(TemplateValues &values, std::string_view kind, const Texts &texts) {
    for (const auto &[name, text] : texts) {
        values.texts[dotted(kind, name)] = text;
    }
}

/// Terms joined into one sum; `none` where there are none.
std::string sum_of(const std::vector<std::string> &terms, const std::string &none = "") {
    return terms.empty() ? none : fmt::format("{}", fmt::join(terms, " + "));
}

std::string in_brackets(const std::vector<std::string> &terms) {
    return terms.size() > 1 ? "(" + sum_of(terms) + ")" : sum_of(terms);
}

/// The lights of one kind, seen from one stage.
struct LightPart {
    const LightKind &kind;
    const Features &program;
    const StageNeeds &stage;
    const LightFeatures &features;
    const LightNeeds &here; ///< in this stage
};

/// "PointLight"; a full program has but one type.
std::string type_name(const Features &program, const LightKind &kind) {
    const auto first = static_cast<char>(std::toupper(static_cast<unsigned char>(kind.word[0])));
    return program.is_full() ? "Light" : fmt::format("{}{}Light", first, kind.word.substr(1));
}

/// The array that holds the lights of a kind, and what is interpolated of them.
void add_array(TemplateValues &values, const LightKind &kind, const Features &program, const LightFeatures &has,
               const LightNeeds &handed) {
    add_flags(values, kind.word,
              {{"many", has.count > 1},
               {"positional", kind.positional},
               {"directed", kind.directed},
               {"ambient", has.ambient},
               {"attenuated_ambient", has.attenuated_ambient},
               {"diffuse", has.diffuse},
               {"specular", has.specular},
               {"given_half_vector", has.given_half_vector},
               {"constant", has.constant},
               {"linear", has.linear},
               {"quadratic", has.quadratic},
               {"cone", has.cone()},
               {"narrow_cone", has.narrow_cone},
               {"hard_cone", has.hard_cone},
               {"soft_cone", has.soft_cone},
               {"exponent", has.exponent},
               {"varying_any", handed.given_any()},
               {"varying_L", handed.given_L},
               {"varying_H", handed.given_H},
               {"varying_R", handed.given_R},
               {"varying_distance", handed.given_distance},
               {"varying_attenuation", handed.given_attenuation}});
    add_texts(values, kind.word,
              {{"v", program.is_full() ? "v" : fmt::format("v_{}", kind.word)},
               {"type", type_name(program, kind)},
               {"array", program.is_full() ? "lights" : fmt::format("{}_lights", kind.word)},
               {"count", std::to_string(has.count)}});
}

std::string attenuation_denominator(const LightFeatures &f, const std::string &light) {
    std::vector<std::string> terms;
    for (const auto &[there, term] :
         {std::pair{f.constant, ".constant"}, {f.linear, ".linear * d"}, {f.quadratic, ".quadratic * d * d"}}) {
        if (there) {
            terms.push_back(light + term);
        }
    }
    return sum_of(terms, "1.0");
}

/// A value of a technique key as its GLSL names it: "blinn_phong".
std::string glsl_name(const TechniqueValue &value) {
    std::string name(value.name);
    std::ranges::replace(name, '-', '_');
    return name;
}

std::string glsl_name(Model model) { return glsl_name(model_values[static_cast<std::size_t>(model)]); }

/// f^n of one model, as it is called.
std::string highlight_of(Model model, const LightPart &light) {
    if (mirrors_view(model)) {
        return fmt::format("{}({})", glsl_name(model), light.here.given_R ? "normalize(mirrored), V" : "R, L");
    }
    std::string half = light.here.given_H ? "H" : "L + V";
    if (light.program.is_full()) {
        half = fmt::format("{}_given_half_vector ? light.half_vector : {}", light.kind.word, half);
    } else if (light.features.given_half_vector) {
        half = "light.half_vector";
    }
    return fmt::format("{}(N, {})", glsl_name(model), half);
}

std::string highlight(const LightPart &light) {
    if (light.program.exponent == Exponent::zero) {
        return "1.0";
    }
    if (!light.program.is_full()) {
        return highlight_of(light.program.technique.model, light);
    }
    std::string text;
    for (const Model model : all_models) {
        if (reflection(model).specular) {
            const std::string call = highlight_of(model, light);
            text = text.empty() ? call : fmt::format("model_{} ? {} : {}", glsl_name(model), call, text);
        }
    }
    return fmt::format("(exponent_zero ? 1.0 : {})", text);
}

/// What a light function is handed besides the light: parameter and argument, in step.
std::pair<std::string, std::string> light_parameters(const LightPart &light, const TemplateValues &values) {
    const LightNeeds &n = light.here;
    const auto varying = [&](const std::string &name) {
        const std::string &prefix = values.texts.at(dotted(light.kind.word, "v"));
        return fmt::format("{}_{}[{}]", prefix, name, light.features.count > 1 ? "i" : "0");
    };
    std::string parameters;
    std::string arguments;
    const auto add = [&](bool needed, const std::string &parameter, const std::string &argument) {
        parameters += needed ? ", " + parameter : "";
        arguments += needed ? ", " + argument : "";
    };
    add(n.uses_P(), "vec3 P", "P");
    add(n.uses_N, "vec3 N", "N");
    add(n.uses_V, "vec3 V", "V");
    add(n.uses_R, "vec3 R", "R");
    add(n.given_L, "vec3 direction", varying("L"));
    add(n.given_H, "vec3 H", varying(values.texts.at("H")));
    add(n.given_R, "vec3 mirrored", varying(values.texts.at("R")));
    add(n.given_distance, "float d", varying("distance"));
    add(n.given_attenuation, "float a", varying("attenuation"));
    add(light.stage.separate_specular && n.adds_specular, "inout vec3 specular", "specular");
    return {parameters, arguments};
}

/// The light's terms: what is added outright, and what attenuation and cone multiply.
void add_sums(TemplateValues &values, const LightPart &light) {
    const LightNeeds &n = light.here;
    const Technique &technique = light.program.technique;
    const bool full = light.program.is_full();
    std::string times = light.features.attenuated() && n.fades ? "a * " : "";
    times += n.uses_cone ? "s * " : "";
    const std::string lit = full || technique.ambient == AmbientWhere::where_lit ? "lit * " : "";
    std::vector<std::string> faded;
    if (n.adds_attenuated_ambient) {
        faded.push_back(lit + "light.attenuated_ambient");
    }
    if (n.adds_diffuse) {
        std::string incidence = technique.direction == DirectionSign::travel ? "n_dot_l" : "-n_dot_l";
        incidence = full ? "direction_unnegated_diffuse ? -n_dot_l : n_dot_l" : incidence;
        faded.push_back(fmt::format("light.diffuse * max({}, 0.0)", light.kind.positional ? "n_dot_l" : incidence));
    }
    const std::string specular = full ? "shine" : "light.specular * highlight";
    if (n.adds_specular && !light.stage.separate_specular) {
        faded.push_back(specular);
    } else if (n.adds_specular && full) {
        faded.emplace_back("(specular_apart ? vec3(0.0) : shine)");
    }
    std::vector<std::string> sum;
    if (n.adds_ambient) {
        sum.push_back(lit + "light.ambient");
    }
    if (!faded.empty()) {
        sum.push_back(times.empty() ? sum_of(faded) : times + in_brackets(faded));
    }
    add_texts(values, light.kind.word,
              {{"sum", sum_of(sum, "vec3(0.0)")},
               {"specular_sum", times.empty() || full ? times + specular : times + "(" + specular + ")"}});
}

/// The function of a kind's lights in one stage.
void add_light(TemplateValues &values, const LightPart &light) {
    const LightFeatures &has = light.features;
    const LightNeeds &n = light.here;
    add_flags(values, light.kind.word,
              {{"used", n.any},
               {"floor", has.floor},
               {"on_surface", has.on_surface},
               {"no_exponent", has.no_exponent},
               {"adds_ambient", n.adds_ambient},
               {"adds_attenuated_ambient", n.adds_attenuated_ambient},
               {"adds_specular", n.adds_specular},
               {"adds_separate_specular", n.adds_specular && light.stage.separate_specular},
               {"uses_n_dot_l", n.uses_n_dot_l},
               {"uses_L", n.uses_L},
               {"finds_L", n.finds_L},
               {"given_L", n.given_L},
               {"finds_distance", n.finds_distance},
               {"finds_attenuation", n.finds_attenuation},
               {"uses_cone", n.uses_cone}});
    const std::string uniform = light_uniform(light.program, light.kind, "i");
    const std::string denominator = attenuation_denominator(has, uniform);
    const auto [parameters, arguments] = light_parameters(light, values);
    const bool full = light.program.is_full();
    add_texts(
        values, light.kind.word,
        {{"kind", std::string(light.kind.word)},
         {"first", full ? fmt::format("{}_first", light.kind.word) : "0"},
         {"end", full ? fmt::format("{}_end", light.kind.word) : std::to_string(has.count)},
         {"uniform", uniform},
         {"parameters", parameters},
         {"arguments", arguments},
         {"denominator", attenuation_denominator(has, "light")},
         {"safe_denominator", has.floor ? fmt::format("max({}, 1e-6)", denominator) : fmt::format("({})", denominator)},
         {"distance", n.finds_distance ? "d" : "length(to_light)"},
         {"highlight", highlight(light)}});
    add_sums(values, light);
}

void add_stage(TemplateValues &values, const Features &f, const StageNeeds &stage, std::string_view name,
               bool fragment) {
    const bool stable_cone = std::ranges::any_of(light_kinds, [&](const LightKind &kind) {
        return stage.lights[kind.type].uses_cone && f.lights[kind.type].stable_exponent;
    });
    add_flags(values, name,
              {{"lit", stage.lit},
               {"P", stage.P},
               {"N", stage.N},
               {"V", stage.V},
               {"R", stage.R},
               {"specular", stage.specular},
               {"separate_specular", stage.separate_specular},
               {"constant_ambient", stage.constant_ambient},
               {"uses_view_direction", stage.V && (f.is_full() || f.technique.viewer == Viewer::infinite)},
               {"stable_power", (stage.specular && f.exponent == Exponent::stable) || stable_cone}});
    std::vector<std::string> parameters;
    std::vector<std::string> arguments;
    const auto add = [&](bool needed, const std::string &parameter, const std::string &argument) {
        if (needed) {
            parameters.push_back(parameter);
            arguments.push_back(argument);
        }
    };
    add(std::ranges::any_of(stage.lights, &LightNeeds::uses_P), "vec3 P", fragment && !f.wide ? "v_position" : "P");
    add(stage.N, "vec3 N", "N");
    add(stage.R || std::ranges::any_of(stage.lights, &LightNeeds::uses_V), "vec3 V", "V");
    add(stage.separate_specular, "inout vec3 specular", fragment ? "specular" : "v_specular");
    std::vector<std::string> back = arguments;
    std::ranges::replace(back, "N", "-N");
    std::ranges::replace(back, "v_specular", "v_back_specular");
    add_texts(values, name,
              {{"surface_parameters", fmt::format("{}", fmt::join(parameters, ", "))},
               {"surface_arguments", fmt::format("{}", fmt::join(arguments, ", "))},
               {"back_arguments", fmt::format("{}", fmt::join(back, ", "))},
               {"first_sum", stage.constant_ambient ? "ambient" : "vec3(0.0)"},
               {"before_base", f.has_base() ? ", before the base colour multiplies it" : ""}});
}

/// The fragment's colour, as one expression.
std::string color_expression(const Features &f, const ProgramNeeds &needs) {
    const bool apart = f.has_base() && !f.base_times_specular; // specular light is no part of `multiplied`
    std::vector<std::string> multiplied;
    std::vector<std::string> plain;
    if (needs.vertex.lit) {
        multiplied.emplace_back(needs.both_sides ? "vertex_light" : "v_light");
    }
    if (needs.fragment.lit && needs.vertex.lit && apart) {
        plain.emplace_back(f.is_full() ? "(specular_apart ? vec3(1.0) : base) * light" : "light");
    } else if (needs.fragment.lit) {
        multiplied.emplace_back("light");
    } else if (needs.fragment.constant_ambient) {
        multiplied.emplace_back("ambient");
    }
    if (needs.vertex.separate_specular || needs.fragment.separate_specular) {
        const std::string at_vertices = needs.both_sides ? "vertex_specular" : "v_specular";
        plain.emplace_back(needs.vertex.separate_specular ? at_vertices : "specular");
    }
    if (f.emission) {
        plain.emplace_back("emission");
    }
    if (f.has_base() && !multiplied.empty()) {
        plain.insert(plain.begin(), "base * " + in_brackets(multiplied));
    } else {
        plain.insert(plain.begin(), multiplied.begin(), multiplied.end());
    }
    return sum_of(plain, "vec3(0.0)");
}

void add_program(TemplateValues &values, const Features &f, const ProgramNeeds &needs) {
    const Technique &technique = f.technique;
    const bool full = f.is_full();
    const bool model_matrix = technique.normals == Normals::model_matrix;
    const bool off_eye = f.off_eye() && technique.viewer == Viewer::local;
    values.flags.insert(
        {{"full", full},
         {"flat", needs.attributes.flat},
         {"vectors", needs.vectors},
         {"both_sides", needs.both_sides},
         {"reads_normal", needs.attributes.normal},
         {"reads_uv", needs.attributes.uv},
         {"reads_centroid", needs.attributes.centroid},
         {"reads_checker", f.chequered},
         {"reads_color", f.colored},
         {"colored_too", f.colored && (f.textured || f.chequered)},
         {"reads_model", needs.vertex.P || f.normal_transform == NormalTransform::rigid || model_matrix || full},
         {"reads_normal_matrix", f.normal_transform == NormalTransform::general && !model_matrix},
         {"reads_eye",
          technique.position == LightingPosition::w0 || (off_eye && needs.vertex.V) || (full && needs.vertex.P)},
         {"fragment.reads_eye", needs.fragment.V && !needs.vectors && !f.wide && (off_eye || full)},
         {"passes_view", needs.vectors && needs.fragment.V && (full || technique.viewer == Viewer::local)},
         {"reads_exponent", f.exponent == Exponent::textbook || f.exponent == Exponent::stable},
         {"guard_normal", f.guard_normal},
         {"guard_vertex_normal", f.guard_vertex_normal},
         {"emission", f.emission},
         {"object_ids", f.object_ids},
         {"shown", f.shown},
         {"srgb", f.srgb},
         {"exposed", f.exposed},
         {"deep", f.deep},
         {"orthographic", f.orthographic},
         {"wide", f.wide},
         {"mediump", f.mediump}});
    values.texts.insert({{"flat", needs.attributes.flat ? "flat " : ""},
                         {"H", full ? "reflection" : "H"}, // a full program interpolates the one that it needs
                         {"R", full ? "reflection" : "R"},
                         {"vertex.point", needs.attributes.centroid ? "a_centroid" : "a_position"},
                         {"fragment.to_eye", needs.vectors ? "v_view"
                                             : f.wide      ? "-P"
                                             : off_eye     ? "eye - v_position"
                                             : full        ? "(off_eye ? eye : vec3(0.0)) - v_position"
                                                           : "-v_position"},
                         {"fragment.color", color_expression(f, needs)}});
    for (const Model model : all_models) {
        const std::string name = glsl_name(model);
        const bool used = full || (model == technique.model && f.exponent != Exponent::zero);
        values.lists["model"].push_back(name);
        add_flags(values, name, {{"used", used && reflection(model).specular}});
        add_texts(values, name, {{"function", name}});
    }
}

/// Of a full program: all that some light has, for lights of every kind.
void add_shared_array(TemplateValues &values, const Features &f, const ProgramNeeds &needs) {
    const LightKind every{.type = {}, .word = "every", .positional = true, .directed = true, .conical = true};
    LightFeatures has = every_light_feature(every, f);
    has.given_half_vector = true;
    LightNeeds handed;
    handed.given_L = handed.given_H = handed.given_distance = needs.vectors;
    add_array(values, every, f, has, handed);
    values.lists["array"] = {"every"};
}

} // namespace

std::string light_uniform(const Features &program, const LightKind &kind, const std::string &index) {
    if (program.is_full()) {
        return fmt::format("lights[{}]", index);
    }
    return program.lights[kind.type].count > 1 ? fmt::format("{}_lights[{}]", kind.word, index)
                                               : fmt::format("the_{}_light", kind.word);
}

std::vector<std::pair<std::string, bool>> choices(const Features &f) {
    std::vector<std::pair<std::string, bool>> all{{"normals_rigid", f.normal_transform == NormalTransform::rigid},
                                                  {"normals_general", f.normal_transform == NormalTransform::general},
                                                  {"off_eye", f.off_eye()},
                                                  {"two_sided", f.two_sided},
                                                  {"textured", f.textured},
                                                  {"chequered", f.chequered},
                                                  {"specular_apart", f.has_base() && !f.base_times_specular},
                                                  {"mirrors_view", mirrors_view(f.technique.model)},
                                                  {"exponent_zero", f.exponent == Exponent::zero},
                                                  {"exponent_one", f.exponent == Exponent::one},
                                                  {"exponent_stable", f.exponent == Exponent::stable}};
    for (const TechniqueKey &key : technique_keys()) {
        for (std::size_t i = 0; i < key.values.size(); ++i) {
            all.emplace_back(fmt::format("{}_{}", key.name, glsl_name(key.values[i])),
                             key.get(f.technique) == static_cast<int>(i));
        }
    }
    for (const LightKind &kind : light_kinds) {
        const LightFeatures &light = f.lights[kind.type];
        all.emplace_back(fmt::format("{}.given_half_vector", kind.word), light.given_half_vector);
        all.emplace_back(fmt::format("{}.narrow_cone", kind.word), light.narrow_cone);
        all.emplace_back(fmt::format("{}.stable_exponent", kind.word), light.stable_exponent);
    }
    return all;
}

void choose_stage(TemplateValues &values, const Features &f, const ProgramNeeds &needs, Stage which) {
    const bool vertex = which == Stage::vertex;
    const StageNeeds &stage = vertex ? needs.vertex : needs.fragment;
    values.texts["way"] = vertex ? "out" : "in";
    add_stage(values, f, stage, "stage", !vertex);
    bool declares_lights = false;
    for (const LightKind &kind : light_kinds) {
        const LightPart part{kind, f, stage, f.lights[kind.type], stage.lights[kind.type]};
        const bool declared = part.here.any || (vertex && needs.fragment.lights[kind.type].given_any());
        declares_lights |= declared;
        add_flags(values, kind.word, {{"declared", declared}});
        add_light(values, part);
    }
    values.flags["vertex.declares_lights"] = declares_lights;
    values.flags["every.declared"] = declares_lights;
}

TemplateValues template_values(const Features &f, const ProgramNeeds &needs, Stage stage) {
    TemplateValues values;
    for (auto &[name, on] : choices(f)) {
        if (f.is_full()) {
            values.choices.insert(name);
        } else {
            values.flags[name] = on;
        }
    }
    add_program(values, f, needs);
    add_stage(values, f, needs.vertex, "vertex", false);
    add_stage(values, f, needs.fragment, "fragment", true);
    add_own_shading(values, f, needs);
    for (const LightKind &kind : light_kinds) {
        values.lists["light"].emplace_back(kind.word);
        add_array(values, kind, f, f.lights[kind.type], needs.fragment.lights[kind.type]);
    }
    values.lists["array"] = values.lists["light"];
    if (f.is_full()) {
        add_shared_array(values, f, needs);
    }
    choose_stage(values, f, needs, stage);
    return values;
}

} // namespace sandbox
