#include "shading/template_values.h"

#include "shading/light_template.h"
#include "shading/own_template.h"
#include "shading/template_fill.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandbox {
namespace {
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

/// f raised to 2 `below`, ... 2^k <= n: "f2 = f * f, f4 = f2 * f2".
std::string squares(int n, int below = 1) {
    std::vector<std::string> all;
    std::string root = below == 1 ? "f" : fmt::format("f{}", below);
    for (int power = 2 * below; power <= n; power *= 2) {
        all.push_back(fmt::format("f{0} = {1} * {1}", power, root));
        root = fmt::format("f{}", power);
    }
    return fmt::format("{}", fmt::join(all, ", "));
}

/// Those of them whose product is f^n: "f32 * f4".
std::string product(int n) {
    std::vector<std::string> factors;
    for (int power = 1; power <= n; power *= 2) {
        if ((n & power) != 0) {
            factors.insert(factors.begin(), power == 1 ? "f" : fmt::format("f{}", power));
        }
    }
    return fmt::format("{}", fmt::join(factors, " * "));
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
         {"reads_exponent",
          (f.exponent == Exponent::textbook && f.whole_exponent == 0) || f.exponent == Exponent::stable},
         {"exponent_whole", f.whole_exponent > 0},
         {"exponent_odd", f.whole_exponent % 2 == 1},
         {"exponent_two", f.whole_exponent == 2},
         {"guard_normal", f.guard_normal},
         {"guard_vertex_normal", f.guard_vertex_normal},
         {"emission", f.emission},
         {"object_ids", f.object_ids},
         {"shown", f.shown},
         {"srgb", f.srgb},
         {"exposed", f.exposed},
         {"deep", f.deep},
         {"invariant", f.invariant},
         {"orthographic", f.orthographic},
         {"wide", f.wide},
         {"mediump", f.mediump}});
    const bool naive = technique.power == Power::naive && !full;
    const bool half_floats = technique.precision == Precision::medium || f.mediump; // a short H may square to 0
    const bool opposite = half_floats || std::ranges::any_of(f.lights, &LightFeatures::opposite);
    values.texts.insert({{"half_vector", naive      ? ""
                                         : opposite ? ", here of any length. H = N where L = -V"
                                                    : ", here of any length"},
                         {"where_H", opposite ? "h2 > 0.0 ? " : ""},
                         {"else_N", opposite ? " : 1.0" : ""},
                         {"flat", needs.attributes.flat ? "flat " : ""},
                         {"H", full ? "reflection" : "H"}, // a full program interpolates the one that it needs
                         {"R", full ? "reflection" : "R"},
                         {"vertex.point", needs.attributes.centroid ? "a_centroid" : "a_position"},
                         {"fragment.to_eye", needs.vectors ? "v_view"
                                             : f.wide      ? "-P"
                                             : off_eye     ? "eye - v_position"
                                             : full        ? "(off_eye ? eye : vec3(0.0)) - v_position"
                                                           : "-v_position"},
                         {"squares", squares(f.whole_exponent)},
                         {"squares_of_f2", squares(f.whole_exponent, 2)},
                         {"product", product(f.whole_exponent)},
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
        const bool rounded = !vertex && f.technique.precision == Precision::medium;
        const LightPart part{kind, f, stage, f.lights[kind.type], stage.lights[kind.type], rounded};
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
