#include "tools/answer_class.h"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace sandbox {
namespace {

struct WrongWay {
    const char *term, *fault, *line;
};
/// A line of the answer, in ways that are right and in ways that are wrong.
struct Slot {
    const char *name;
    std::vector<const char *> right;
    std::vector<WrongWay> wrong;
};

constexpr const char *template_text = R"(float fading(Light k, vec3 P)
{
    if (k.type == DIRECTIONAL) {
        return 1.0;
    }
    @distance
    float a = @attenuation;
    if (k.type == SPOT && k.cutoff_degrees < 180.0) {
        @cosine
        float s = k.cos_inner_cutoff > k.cos_cutoff ? @edge : step(k.cos_cutoff, c);
        a *= s * @exponent;
    }
    return a;
}

vec3 lighting(vec3 P, vec3 N, vec3 eye)
{
    @normal
    @view
    @scene
    vec3 d = vec3(0.0);
    vec3 s = vec3(0.0);
    for (@lights) {
        Light k = lights[i];
        vec3 l = @light;
        float f = fading(k, P);
        float lambert = @lambert;
        a += @ambient * (k.attenuate_ambient ? f : 1.0);
        d += @diffuse * f;
        if (@gate) {
            s += @specular * f;
        }
    }
    return @result;
}
)";

std::vector<Slot> common_slots() {
    return {
        {"distance",
         {"float r = length(k.position - P);", "float r = distance(P, k.position);",
          "vec3 way = P - k.position; float r = sqrt(dot(way, way));"},
         {{"attenuation", "distance-squared", "vec3 way = k.position - P; float r = dot(way, way);"},
          {"attenuation", "distance-of-origin", "float r = length(k.position);"}}},
        {"attenuation",
         {"1.0 / (k.constant + k.linear * r + k.quadratic * r * r)",
          "1.0 / (k.constant + r * (k.linear + r * k.quadratic))",
          "1.0 / dot(vec3(k.constant, k.linear, k.quadratic), vec3(1.0, r, r * r))"},
         {{"attenuation", "no-attenuation", "1.0"},
          {"attenuation", "attenuation-multiplied", "(k.constant + k.linear * r + k.quadratic * r * r)"},
          {"attenuation", "no-linear", "1.0 / (k.constant + k.quadratic * r * r)"},
          {"attenuation", "no-square", "1.0 / (k.constant + k.linear * r + k.quadratic * r)"}}},
        {"cosine",
         {"float c = dot(normalize(P - k.position), k.direction);",
          "float c = -dot(normalize(k.position - P), k.direction);"},
         {{"cone", "cone-reversed", "float c = dot(normalize(k.position - P), k.direction);"}}},
        {"edge",
         {"smoothstep(k.cos_cutoff, k.cos_inner_cutoff, c)",
          "smoothstep(0.0, 1.0, (c - k.cos_cutoff) / (k.cos_inner_cutoff - k.cos_cutoff))"},
         {{"cone", "hard-edge", "step(k.cos_cutoff, c)"},
          {"cone", "linear-edge", "clamp((c - k.cos_cutoff) / (k.cos_inner_cutoff - k.cos_cutoff), 0.0, 1.0)"},
          {"cone", "degrees-for-cosines", "smoothstep(k.cutoff_degrees, k.inner_cutoff_degrees, c)"}}},
        {"exponent",
         {"pow(max(c, 0.0), k.exponent)", "(c > 0.0 ? pow(c, k.exponent) : 0.0)"},
         {{"cone", "no-cone-exponent", "1.0"}}},
        {"normal",
         {"vec3 n = normalize(N);", "vec3 n = N / length(N);", "vec3 n = N * inversesqrt(dot(N, N));",
          "vec3 n = normalize(normalize(N));"},
         {{"specular", "n-not-unit", "vec3 n = N;"}}},
        {"view",
         {"vec3 v = normalize(eye - P);", "vec3 v = -normalize(P - eye);", "vec3 v = (eye - P) / distance(eye, P);"},
         {{"specular", "view-reversed", "vec3 v = normalize(P - eye);"},
          {"specular", "view-from-origin", "vec3 v = normalize(eye);"}}},
        {"scene", {"vec3 a = scene_ambient;", "vec3 a = vec3(0.0) + scene_ambient;"}, {}},
        {"lights",
         {"int i = 0; i < light_count; ++i", "int i = light_count - 1; i >= 0; --i"},
         {{"sum", "first-light-only", "int i = 0; i < 1; ++i"}}},
        {"light",
         {"k.type == DIRECTIONAL ? -k.direction : normalize(k.position - P)",
          "normalize(k.type == DIRECTIONAL ? -k.direction : k.position - P)"},
         {{"diffuse", "light-reversed", "k.type == DIRECTIONAL ? k.direction : normalize(P - k.position)"}}},
        {"lambert",
         {"max(dot(n, l), 0.0)", "clamp(dot(n, l), 0.0, 1.0)", "max(0.0, dot(l, n))",
          "(dot(n, l) > 0.0 ? dot(n, l) : 0.0)"},
         {{"diffuse", "no-max", "dot(n, l)"},
          {"diffuse", "abs", "abs(dot(n, l))"},
          {"diffuse", "wrong-sign", "max(-dot(n, l), 0.0)"},
          {"diffuse", "half-lambert", "(0.5 + 0.5 * dot(n, l))"}}},
        {"ambient",
         {"k.color * k.ambient", "k.ambient * k.color"},
         {{"ambient", "ambient-no-color", "vec3(k.ambient)"},
          {"ambient", "ambient-doubled", "2.0 * k.color * k.ambient"},
          {"ambient", "ambient-where-lit", "k.color * k.ambient * step(0.0001, dot(n, l))"}}},
        {"diffuse",
         {"lambert * k.diffuse * k.color", "k.color * (k.diffuse * lambert)"},
         {{"diffuse", "diffuse-no-color", "vec3(lambert * k.diffuse)"},
          {"diffuse", "diffuse-no-intensity", "lambert * k.color"},
          {"diffuse", "squared-cosine", "lambert * lambert * k.diffuse * k.color"}}},
        {"gate",
         {"dot(n, l) > 0.0", "0.0 < dot(l, n)"},
         {{"specular", "not-gated", "true"}, {"specular", "gated-by-view", "dot(n, v) > 0.0 && true"}}},
        {"result",
         {"material.emission + base() * (material.ambient * a + material.diffuse * d) + "
          "(material.texture_modulates_specular ? "
          "base() : vec3(1.0)) * material.specular * s",
          "(material.texture_modulates_specular ? base() : vec3(1.0)) * s * material.specular + base() * (d * "
          "material.diffuse + a * material.ambient) + material.emission"},
         {{"ambient", "ambient-missing", "material.emission + material.diffuse * d + material.specular * s"},
          {"ambient", "ambient-of-diffuse", "material.emission + material.diffuse * (a + d) + material.specular * s"},
          {"diffuse", "diffuse-no-material", "material.emission + material.ambient * a + d + material.specular * s"},
          {"specular", "specular-no-material", "material.emission + material.ambient * a + material.diffuse * d + s"},
          {"sum", "clamped",
           "clamp(material.emission + material.ambient * a + material.diffuse * d + material.specular * s, 0.0, "
           "1.0)"}}},
    };
}

Slot specular_slot(Model model) {
    switch (model) {
    case Model::phong:
        return {
            "specular",
            {"pow(max(dot(reflect(-l, n), v), 0.0), material.shininess) * k.specular * k.color",
             "k.color * k.specular * pow(max(dot(v, 2.0 * dot(n, l) * n - l), 0.0), material.shininess)",
             "k.specular * k.color * pow(max(dot(l, reflect(-v, n)), 0.0), material.shininess)"},
            {{"specular", "reflect-without-minus",
              "k.color * k.specular * pow(max(dot(reflect(l, n), v), 0.0), material.shininess)"},
             {"specular", "n-doubled",
              "k.color * k.specular * pow(max(dot(reflect(-l, n), v), 0.0), 2.0 * material.shininess)"},
             {"specular", "n-plus-10",
              "k.color * k.specular * pow(max(dot(reflect(-l, n), v), 0.0), material.shininess + 10.0)"},
             {"specular", "no-color", "vec3(k.specular * pow(max(dot(reflect(-l, n), v), 0.0), material.shininess))"},
             {"specular", "times-lambert",
              "lambert * k.color * k.specular * pow(max(dot(reflect(-l, n), v), 0.0), material.shininess)"},
             {"specular", "blinn-for-phong",
              "k.color * k.specular * pow(max(dot(n, normalize(l + v)), 0.0), material.shininess)"}}};
    case Model::blinn_phong:
        return {
            "specular",
            {"pow(max(dot(n, normalize(l + v)), 0.0), blinn_exponent_scale * material.shininess) * k.specular * "
             "k.color",
             "k.color * k.specular * pow(max(dot(n, l + v) / length(l + v), 0.0), material.shininess * "
             "blinn_exponent_scale)",
             "k.specular * k.color * pow(max(dot(normalize(0.5 * (v + l)), n), 0.0), blinn_exponent_scale * "
             "material.shininess)"},
            {{"specular", "half-not-unit", "k.color * k.specular * pow(max(dot(n, l + v), 0.0), material.shininess)"},
             {"specular", "half-averaged",
              "k.color * k.specular * pow(max(dot(n, (l + v) / 2.0), 0.0), material.shininess)"},
             {"specular", "n-halved",
              "k.color * k.specular * pow(max(dot(n, normalize(l + v)), 0.0), 0.5 * material.shininess)"},
             {"specular", "no-intensity", "k.color * pow(max(dot(n, normalize(l + v)), 0.0), material.shininess)"},
             {"specular", "phong-for-blinn",
              "k.color * k.specular * pow(max(dot(reflect(-l, n), v), 0.0), material.shininess)"}}};
    default:
        return {"specular",
                {"vec3(0.0)", "0.0 * k.color"},
                {{"specular", "specular-too",
                  "k.color * k.specular * pow(max(dot(reflect(-l, n), v), 0.0), material.shininess)"}}};
    }
}

const char *chosen(const std::vector<const char *> &ways, std::mt19937 &dice) { return ways[dice() % ways.size()]; }

} // namespace

std::vector<ClassAnswer> answer_class(const Technique &target, const std::vector<std::string> &terms, std::size_t count,
                                      unsigned seed) {
    std::vector<Slot> slots = common_slots();
    slots.push_back(specular_slot(target.model));
    std::vector<std::pair<const Slot *, const WrongWay *>> wrong;
    for (const Slot &slot : slots) {
        for (const WrongWay &way : slot.wrong) {
            if (std::ranges::find(terms, way.term) != terms.end()) {
                wrong.emplace_back(&slot, &way);
            }
        }
    }
    std::mt19937 dice(seed);
    std::vector<ClassAnswer> answers;
    std::size_t next = 0;
    std::ranges::shuffle(wrong, dice);
    for (std::size_t i = 0; i < count; ++i) {
        const bool right = wrong.empty() || dice() % 5 < 2;
        const auto *fault = right ? nullptr : &wrong[next++ % wrong.size()];
        ClassAnswer answer{{},
                           template_text,
                           fault != nullptr ? fault->second->fault : "",
                           fault != nullptr ? fault->second->term : ""};
        for (const Slot &slot : slots) {
            const char *way = chosen(slot.right, dice);
            const std::string name = std::string("@") + slot.name;
            answer.text.replace(answer.text.find(name), name.size(),
                                fault != nullptr && fault->first == &slot ? fault->second->line : way);
        }
        answer.name = fmt::format("{:03}-{}.glsl", i + 1, right ? "right" : answer.fault);
        answers.push_back(std::move(answer));
    }
    return answers;
}

} // namespace sandbox
