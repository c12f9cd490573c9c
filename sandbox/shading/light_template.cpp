#include "shading/light_template.h"

#include "shading/template_fill.h"

#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandbox {
namespace {

/// "PointLight"; a full program has but one type.
std::string type_name(const Features &program, const LightKind &kind) {
    const auto first = static_cast<char>(std::toupper(static_cast<unsigned char>(kind.word[0])));
    return program.is_full() ? "Light" : fmt::format("{}{}Light", first, kind.word.substr(1));
}

/// "point_" where all lights of the kind share the coefficients, else "light." or, with an index, an element's name.
std::string coefficients(const LightPart &light, const std::string &one) {
    return light.features.one_attenuation ? fmt::format("{}_", light.kind.word) : one + ".";
}

/// By Horner's rule; half-float programs round in the textbook's order.
std::string attenuation_denominator(const LightPart &light, const std::string &one) {
    const LightFeatures &f = light.features;
    const std::string of = coefficients(light, one);
    const bool nested = f.linear && f.quadratic && !light.rounded;
    std::vector<std::string> terms;
    if (f.constant) {
        terms.push_back(of + "constant");
    }
    if (nested) {
        terms.push_back(fmt::format("d * ({0}linear + {0}quadratic * d)", of));
    }
    if (f.linear && !nested) {
        terms.push_back(of + "linear * d");
    }
    if (f.quadratic && !nested) {
        terms.push_back(of + "quadratic * d * d");
    }
    return sum_of(terms, "1.0");
}

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

/// What a light function is handed besides the light at `index`: parameter and argument, in step.
std::pair<std::string, std::string> light_parameters(const LightPart &light, const TemplateValues &values,
                                                     const std::string &index) {
    const LightNeeds &n = light.here;
    const auto varying = [&](const std::string &name) {
        const std::string &prefix = values.texts.at(dotted(light.kind.word, "v"));
        return fmt::format("{}_{}[{}]", prefix, name, index);
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

/// Written out where the lights are constants: then the compiler knows each of them.
bool is_unrolled(const LightPart &light) {
    constexpr int most_lights = 8; // a program's length grows with them
    return light.program.is_baked() && !light.rounded && light.features.count <= most_lights;
}

/// The function's result: for the light at i, or for all of them.
std::string calls(const LightPart &light, const TemplateValues &values, bool loops) {
    std::vector<std::string> terms;
    for (int i = 0; i < (loops ? 1 : light.features.count); ++i) {
        const std::string index = loops ? "i" : std::to_string(i);
        terms.push_back(fmt::format("{}_light({}{})", light.kind.word, light_uniform(light.program, light.kind, index),
                                    light_parameters(light, values, index).second));
    }
    return sum_of(terms);
}

/// "light.specular * (a * s * highlight)": colours are multiplied last, by one number.
std::string times(const std::string &color, const std::vector<std::string> &numbers) {
    if (numbers.empty()) {
        return color;
    }
    const std::string product = fmt::format("{}", fmt::join(numbers, " * "));
    return color + " * " + (numbers.size() > 1 ? "(" + product + ")" : product);
}

/// The light's terms, each times what lessens it. Half-float programs round in the textbook's order: attenuation and
/// cone multiply the sum.
void add_sums(TemplateValues &values, const LightPart &light) {
    const LightNeeds &n = light.here;
    const Technique &technique = light.program.technique;
    const bool full = light.program.is_full();
    std::vector<std::string> fade;
    if (light.features.attenuated() && n.fades) {
        fade.emplace_back("a");
    }
    if (n.uses_cone) {
        fade.emplace_back("s");
    }
    const auto faded = [&](const std::string &color, const std::string &number) {
        std::vector<std::string> numbers = light.rounded ? std::vector<std::string>{} : fade;
        if (!number.empty()) {
            numbers.push_back(number);
        }
        return times(color, numbers);
    };
    const bool where_lit = full || technique.ambient == AmbientWhere::where_lit;
    std::vector<std::string> fading;
    if (n.adds_attenuated_ambient) {
        fading.push_back(faded("light.attenuated_ambient", where_lit ? "lit" : ""));
    }
    std::string incidence =
        technique.direction == DirectionSign::travel || light.kind.positional ? "n_dot_l" : "-n_dot_l";
    if (full && !light.kind.positional) {
        incidence = "direction_unnegated_diffuse ? -n_dot_l : n_dot_l";
    }
    const std::string facing = fmt::format("max({}, 0.0)", incidence);
    const std::string specular = full ? "shine" : faded("light.specular", "highlight");
    if (light.features.one_color && n.adds_diffuse) {
        const std::string share =
            light.features.one_share ? fmt::format("{}_", light.kind.word) : std::string("light.");
        fading.push_back(faded("light.diffuse", fmt::format("({} + {}specular_share * highlight)", facing, share)));
    } else {
        if (n.adds_diffuse) {
            fading.push_back(faded("light.diffuse", facing));
        }
        if (n.adds_specular && !light.stage.separate_specular) {
            fading.push_back(specular);
        } else if (n.adds_specular && full) {
            fading.emplace_back("(specular_apart ? vec3(0.0) : shine)");
        }
    }
    const std::string before = light.rounded && !fade.empty() ? fmt::format("{} * ", fmt::join(fade, " * ")) : "";
    std::vector<std::string> sum;
    if (n.adds_ambient) {
        sum.push_back(times("light.ambient", where_lit ? std::vector<std::string>{"lit"} : std::vector<std::string>{}));
    }
    if (!fading.empty()) {
        sum.push_back(before.empty() ? sum_of(fading) : before + in_brackets(fading));
    }
    add_texts(values, light.kind.word,
              {{"sum", sum_of(sum, "vec3(0.0)")},
               {"shine", faded("light.specular", "highlight")},
               {"specular_sum", before.empty() ? specular : before + "(" + specular + ")"}});
}

} // namespace

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
               {"one_color", has.one_color},
               {"one_share", has.one_share},
               {"one_attenuation", has.one_attenuation},
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

void add_light(TemplateValues &values, const LightPart &light) {
    const LightFeatures &has = light.features;
    const LightNeeds &n = light.here;
    const bool full = light.program.is_full();
    const bool loops = full || (has.count > 1 && !is_unrolled(light));
    add_flags(values, light.kind.word,
              {{"used", n.any},
               {"loops", loops},
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
    const std::string denominator = attenuation_denominator(light, uniform);
    add_texts(
        values, light.kind.word,
        {{"kind", std::string(light.kind.word)},
         {"first", full ? fmt::format("{}_first", light.kind.word) : "0"},
         {"end", full ? fmt::format("{}_end", light.kind.word) : std::to_string(has.count)},
         {"uniform", uniform},
         {"calls", calls(light, values, loops)},
         {"parameters", light_parameters(light, values, "").first},
         {"denominator", attenuation_denominator(light, "light")},
         {"safe_denominator", has.floor ? fmt::format("max({}, 1e-6)", denominator) : fmt::format("({})", denominator)},
         {"distance", n.finds_distance ? "d" : "length(to_light)"},
         {"highlight", highlight(light)}});
    add_sums(values, light);
}

std::string light_uniform(const Features &program, const LightKind &kind, const std::string &index) {
    if (program.is_full()) {
        return fmt::format("lights[{}]", index);
    }
    return program.lights[kind.type].count > 1 ? fmt::format("{}_lights[{}]", kind.word, index)
                                               : fmt::format("the_{}_light", kind.word);
}

} // namespace sandbox
