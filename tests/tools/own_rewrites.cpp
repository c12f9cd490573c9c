#include "tools/own_rewrites.h"

#include "scene/light_kind.h"
#include "scene/scene_file.h"
#include "shading/own_text.h"
#include "tools/stress_dice.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <initializer_list>
#include <utility>
#include <vector>

namespace sandbox {
namespace {

/// Where the work of one light goes.
enum class Shape { up, down, at_once, unrolled, halves, two_passes, function, last };

class Writer {
  public:
    Writer(std::uint32_t seed, const Scene &scene, Model model)
        : dice_(0x0E17, seed), scene_(scene), specular_(reflection(model).specular),
          half_vector_(reflection(model).half_vector), shape_(static_cast<Shape>(dice_.below(int(Shape::last)))),
          view_space_(dice_.chance(0.3)), copies_(dice_.chance(0.5)), by_material_(dice_.chance(0.4)),
          array_(!by_material_ && dice_.chance(0.2)) {
        for (const Light &light : scene.lights) {
            lights_ += light.enabled ? 1 : 0;
        }
        if (lights_ > 4 && shape_ == Shape::unrolled) {
            shape_ = Shape::up;
        }
        based_ = std::ranges::any_of(scene.objects, [](const Object &object) {
            return object.material.checker || !object.material.texture.empty();
        });
    }

    std::string text() {
        std::string functions = view_space_ ? basis() : "";
        functions += dice_.chance(0.4) ? "vec3 unit(vec3 v)\n{\n    return " + unit_of("v") + ";\n}\n\n" : "";
        has_unit_ = !functions.empty() && functions.find("unit(vec3 v)") != std::string::npos;
        std::string begin = vectors();
        const std::string work = body();
        const bool apart = shape_ == Shape::function || shape_ == Shape::unrolled;
        if (apart) {
            functions +=
                "void add_light(int i, vec3 P, vec3 N, vec3 V, " + parameters("inout ") + ")\n{\n" + work + "}\n\n";
        }
        std::string lighting = functions + "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n" + begin;
        lighting += accumulators() + loops(work) + result() + "}\n";
        return lighting;
    }

  private:
    std::string pick(std::initializer_list<const char *> ways) {
        return *(ways.begin() + dice_.below(static_cast<std::uint32_t>(ways.size())));
    }
    static std::string put(std::string text, const std::string &what, const std::string &in) {
        for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + in.size())) {
            text.replace(at, what.size(), in);
        }
        return text;
    }

    std::string unit_of(const std::string &v) {
        if (has_unit_ && dice_.chance(0.5)) {
            return "unit(" + v + ")";
        }
        return put(pick({"normalize(#)", "(#) * inversesqrt(dot(#, #))", "(#) / length(#)", "normalize(normalize(#))",
                         "normalize(0.5 * (#))", "(#) / sqrt(dot(#, #))"}),
                   "#", v);
    }
    std::string positive(const std::string &x) {
        return put(pick({"max(#, 0.0)", "clamp(#, 0.0, 1.0)", "(# > 0.0 ? # : 0.0)", "max(0.0, #)", "# * step(0.0, #)",
                         "0.5 * (# + abs(#))"}),
                   "#", x);
    }
    std::string power(const std::string &f, const std::string &n) {
        return put(put(pick({"pow(#, @)", "(# > 0.0 ? exp2(@ * log2(#)) : 0.0)", "(# > 0.0 ? exp(@ * log(#)) : 0.0)",
                             "pow(#, 0.5 * @) * pow(#, 0.5 * @)"}),
                       "#", f),
                   "@", n);
    }

    /// The camera's axes, up to a turn about its own: view space has its origin in the eye.
    std::string basis() {
        return "mat3 to_view()\n{\n    vec3 z = view_axis;\n"
               "    vec3 x = normalize(cross(abs(z.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), z));\n" +
               pick({"    return transpose(mat3(x, cross(z, x), z));\n",
                     "    vec3 y = cross(z, x);\n    return mat3(x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z);\n"}) +
               "}\n\n";
    }
    /// N, V and P as the work takes them.
    std::string vectors() {
        std::string lines;
        if (view_space_) {
            lines += "    P = to_view() * (P - eye);\n    N = to_view() * N;\n";
            lines += "    N = " + unit_of("N") + ";\n";
        } else {
            lines += "    N = " + unit_of("N") + ";\n";
        }
        if (specular_) {
            if (is_orthographic(scene_.camera)) {
                lines += view_space_ ? "    vec3 V = vec3(0.0, 0.0, 1.0);\n" : "    vec3 V = view_axis;\n";
            } else if (view_space_) {
                lines += "    vec3 V = " + pick({"normalize(-P)", "-normalize(P)", "-P / length(P)"}) + ";\n";
            } else {
                lines += "    vec3 V = " +
                         pick({"normalize(eye - P)", "-normalize(P - eye)", "(eye - P) / distance(eye, P)"}) + ";\n";
            }
        } else {
            lines += "    vec3 V = vec3(0.0);\n";
        }
        return lines;
    }

    /// The light's field, of a copy or of the array.
    [[nodiscard]] std::string field(const char *name) const {
        return (copies_ ? std::string("light.") : std::string("lights[i].")) + name;
    }
    [[nodiscard]] std::string in_space(const std::string &v) const {
        return view_space_ ? "(to_view() * " + v + ")" : v;
    }

    /// L and d, and `fades`: attenuation and cone.
    std::string towards() {
        const std::string position =
            view_space_ ? "(to_view() * (" + field("position") + " - eye))" : field("position");
        const std::string axis = in_space(field("direction"));
        std::string lines = "        vec3 D = " + pick({"# - P", "-(P - #)"}) + ";\n";
        lines = put(lines, "#", position);
        lines += "        float d = " + pick({"length(D)", "sqrt(dot(D, D))"}) + ";\n";
        lines += "        vec3 L = " + pick({"D / d", "normalize(D)", "D * inversesqrt(dot(D, D))"}) + ";\n";
        lines += "        float fades = " +
                 put(pick({"1.0 / (#constant + #linear * d + #quadratic * d * d)",
                           "1.0 / (#constant + d * (#linear + d * #quadratic))",
                           "1.0 / dot(vec3(1.0, d, d * d), vec3(#constant, #linear, #quadratic))",
                           "1.0 / (d * d * #quadratic + (d * #linear + #constant))"}),
                     "#", field("")) +
                 ";\n";
        lines += "        if (" + field("type") + " == DIRECTIONAL) {\n            L = -" + axis +
                 ";\n            fades = 1.0;\n        }\n";
        lines += "        if (" + field("type") + " == SPOT && " + field("cutoff_degrees") + " < 180.0) {\n";
        lines += "            float c = " + pick({"dot(-L, @)", "-dot(L, @)"}) + ";\n";
        lines += "            if (" + field("cos_inner_cutoff") + " > " + field("cos_cutoff") + ") {\n";
        lines += pick({"                fades *= smoothstep(#cos_cutoff, #cos_inner_cutoff, c);\n",
                       "                float t = clamp((c - #cos_cutoff) / (#cos_inner_cutoff - #cos_cutoff), 0.0, "
                       "1.0);\n                fades *= t * t * (3.0 - 2.0 * t);\n"});
        lines += "            } else if (c < #cos_cutoff) {\n                fades = 0.0;\n            }\n";
        lines += "            fades *= c > 0.0 ? pow(c, #exponent) : 0.0;\n        }\n";
        return put(put(lines, "@", axis), "#", field(""));
    }

    std::string ambient() {
        const std::string faded =
            pick({"(#attenuate_ambient ? fades : 1.0)", "mix(1.0, fades, float(#attenuate_ambient))"});
        return "        " + sum(0) + " += " +
               put(pick({"#color * #ambient * "
                         "@",
                         "#ambient * @ * #color"}),
                   "@", faded) +
               weight(0) + ";\n";
    }
    std::string diffuse() {
        return "        " + sum(1) + " += " +
               put(pick({"#color * #diffuse * @ * fades", "fades * (#diffuse * @) * #color",
                         "#color * (fades * @ * #diffuse)"}),
                   "@", positive("n_dot_l")) +
               weight(1) + ";\n";
    }
    std::string shine() {
        std::string lines;
        if (half_vector_) {
            lines +=
                pick({"        vec3 H = normalize(L + V);\n        float f = max(dot(N, H), 0.0);\n",
                      "        vec3 H = (L + V) * inversesqrt(dot(L + V, L + V));\n        float f = max(dot(H, N), "
                      "0.0);\n",
                      "        vec3 H = L + V;\n        float f = max(dot(N, H) / length(H), 0.0);\n",
                      "        vec3 H = normalize(mix(L, V, 0.5));\n        float f = clamp(dot(N, H), 0.0, 1.0);\n",
                      "        float f = max((n_dot_l + dot(N, V)) * inversesqrt(max(2.0 + 2.0 * dot(L, V), "
                      "1e-6)), 0.0);\n"});
        } else {
            lines += pick({"        float f = max(dot(reflect(-L, N), V), 0.0);\n",
                           "        vec3 R = 2.0 * n_dot_l * N - L;\n        float f = max(dot(R, V), 0.0);\n",
                           "        float f = max(dot(L, reflect(-V, N)), 0.0);\n",
                           "        float f = max(2.0 * n_dot_l * dot(N, V) - dot(L, V), 0.0);\n",
                           "        vec3 R = n_dot_l * N + (n_dot_l * N - L);\n        float f = clamp(dot(V, R), 0.0, "
                           "1.0);\n"});
        }
        const std::string n =
            half_vector_
                ? pick({"blinn_exponent_scale * material.shininess", "material.shininess * blinn_exponent_scale"})
                : "material.shininess";
        lines += "        float n = " + n + ";\n";
        const std::string raised = "        float raised = " + power("f", "n") + ";\n";
        const std::string add =
            sum(2) + " += " + pick({"#color * #specular * raised * fades", "fades * #specular * (raised * #color)"}) +
            weight(2) + ";\n";
        const bool can_leave = shape_ != Shape::two_passes || passes_ == 1;
        switch (dice_.below(can_leave ? 4 : 3)) {
        case 0:
            return lines + raised + "        if (n_dot_l > 0.0) {\n            " + add + "        }\n";
        case 1:
            return lines + raised + "        raised *= n_dot_l > 0.0 ? 1.0 : 0.0;\n        " + add;
        case 2:
            return lines + raised + "        raised = float(n_dot_l > 0.0) * raised;\n        " + add;
        default:
            return "        if (n_dot_l <= 0.0) {\n            @leave;\n        }\n" + lines + raised + "        " +
                   add;
        }
    }

    /// The names that the light is added up in: ambient, diffuse, specular.
    [[nodiscard]] std::string sum(int term) const {
        if (by_material_) {
            return "total";
        }
        return array_ ? fmt::format("sums[{}]", term) : std::array{"ambient", "diffuse", "specular"}[std::size_t(term)];
    }
    /// The material's factor, where it is taken at once.
    [[nodiscard]] std::string weight(int term) const {
        if (!by_material_) {
            return "";
        }
        const std::string name = std::array{"ambient", "diffuse", "specular"}[std::size_t(term)];
        return " * material." + name + (based_ ? (term == 2 ? " * shine_base()" : " * base()") : "");
    }
    [[nodiscard]] std::string parameters(const std::string &how) const {
        if (by_material_) {
            return how + "vec3 total" + eye_parameter();
        }
        if (array_) {
            return how + "vec3 sums[3]" + eye_parameter();
        }
        return fmt::format("{0}vec3 ambient, {0}vec3 diffuse, {0}vec3 specular", how) + eye_parameter();
    }
    [[nodiscard]] static std::string eye_parameter() { return ", vec3 eye"; }
    [[nodiscard]] std::string passed() const {
        return std::string(by_material_ ? "total" : array_ ? "sums" : "ambient, diffuse, specular") + ", eye";
    }
    [[nodiscard]] std::string accumulators() const {
        if (by_material_) {
            return std::string("    vec3 total = scene_ambient * material.ambient") + (based_ ? " * base()" : "") +
                   ";\n";
        }
        if (array_) {
            return "    vec3 sums[3];\n    sums[0] = scene_ambient;\n    sums[1] = vec3(0.0);\n    sums[2] = "
                   "vec3(0.0);\n";
        }
        return "    vec3 ambient = scene_ambient;\n    vec3 diffuse = vec3(0.0);\n    vec3 specular = vec3(0.0);\n";
    }

    /// What one light adds.
    std::string body() {
        const std::string copy = copies_ ? "        Light light = lights[i];\n" : "";
        const std::string begin =
            copy + towards() + "        float n_dot_l = " + pick({"dot(N, L)", "dot(L, N)"}) + ";\n";
        std::vector<std::string> parts{ambient(), diffuse()};
        if (dice_.chance(0.5)) {
            std::swap(parts[0], parts[1]);
        }
        if (shape_ == Shape::two_passes && specular_) {
            passes_ = 2;
            second_ = put(begin + shine(), "#", field(""));
            return put(begin + parts[0] + parts[1], "#", field(""));
        }
        std::string work = begin + parts[0] + parts[1];
        if (specular_) {
            std::string specular = shine();
            const bool leaves = specular.find("@leave") != std::string::npos;
            work = !leaves && dice_.chance(0.5) ? begin + parts[0] + specular + parts[1] : work + specular;
        }
        return put(work, "#", field(""));
    }
    std::string loops(const std::string &work) {
        const auto loop = [&](const std::string &head, const std::string &what) {
            return "    " + head + " {\n" + put(what, "@leave", "continue") + "    }\n";
        };
        const std::string up = "for (int i = 0; i < light_count; ++i)";
        const std::string down = "for (int i = light_count - 1; i >= 0; --i)";
        const std::string call = "        add_light(i, P, N, V, " + passed() + ");\n";
        std::string lines;
        switch (shape_) {
        case Shape::down:
            return loop(down, work);
        case Shape::at_once:
            return "    int next = 0;\n" + loop("while (next < light_count)", "        int i = next++;\n" + work);
        case Shape::unrolled:
            for (int i = 0; i < lights_; ++i) {
                lines += put(call.substr(4), "(i,", fmt::format("({},", i));
            }
            return lines;
        case Shape::halves:
            return loop("for (int i = 0; i < light_count / 2; ++i)", work) +
                   loop("for (int i = light_count / 2; i < light_count; ++i)", work);
        case Shape::two_passes:
            return loop(up, work) + (specular_ ? loop(dice_.chance(0.5) ? down : up, second_) : "");
        case Shape::function:
            return loop(dice_.chance(0.5) ? up : down, call);
        default:
            return loop(up, work);
        }
    }

    std::string result() {
        if (by_material_) {
            return "    return " + pick({"total + material.emission", "material.emission + total"}) + ";\n";
        }
        std::string line =
            "    return " +
            pick({"material.emission + @b * (material.ambient * @0 + material.diffuse * @1) + @s * material.specular * "
                  "@2",
                  "@s * (@2 * material.specular) + (material.diffuse * @1 * @b + @b * material.ambient * @0) + "
                  "material.emission",
                  "@0 * material.ambient * @b + @1 * material.diffuse * @b + @2 * material.specular * @s + "
                  "material.emission"}) +
            ";\n";
        for (int term = 0; term < 3; ++term) {
            line = put(line, fmt::format("@{}", term), sum(term));
        }
        return put(put(line, "@b", based_ ? "base()" : "1.0"), "@s", based_ ? "shine_base()" : "1.0");
    }

  public:
    [[nodiscard]] bool needs_shine_base() const { return based_; }

  private:
    StressDice dice_;
    const Scene &scene_;
    bool specular_, half_vector_;
    Shape shape_;
    bool view_space_, copies_, by_material_, array_;
    bool has_unit_ = false, based_ = false;
    int lights_ = 0, passes_ = 1;
    std::string second_; ///< pass
};

} // namespace

std::string rewritten_lighting(std::uint32_t seed, const Scene &scene, Model model) {
    Writer writer(seed, scene, model);
    std::string text = writer.text();
    // In a function of its own the work of a light ends by returning.
    for (auto at = text.find("@leave"); at != std::string::npos; at = text.find("@leave")) {
        text.replace(at, 6, "return");
    }
    const char *shine_base = "vec3 shine_base()\n{\n"
                             "    return material.texture_modulates_specular ? base() : vec3(1.0);\n}\n\n";
    return writer.needs_shine_base() ? shine_base + text : text;
}

OwnRewrite own_rewrite(std::uint32_t seed) {
    constexpr const char *names[]{
        "three-point-lights",       "spot-light",       "directional-light", "box-4-normal-matrix", "vase", "studio",
        "three-directional-lights", "chequered-sphere", "point-light",       "box-5-specular"};
    constexpr Frequency frequencies[]{Frequency::per_pixel, Frequency::per_pixel, Frequency::per_pixel,
                                      Frequency::per_vertex, Frequency::flat};
    StressDice dice(0x0E16, seed);
    OwnRewrite rewrite;
    rewrite.scene_name = dice.one_of(names);
    constexpr Model models[]{Model::phong, Model::phong, Model::blinn_phong, Model::blinn_phong, Model::lambert};
    rewrite.truth.frequency = dice.one_of(frequencies);
    rewrite.truth.model = dice.one_of(models);
    rewrite.given = !dice.chance(0.25);
    rewrite.scene = open_scene(rewrite.scene_name, Assets("assets"));
    const double stiff = dice.chance(0.15) ? 100 : 1;
    for (Object &object : rewrite.scene.objects) {
        object.material.shininess *= stiff;
    }
    rewrite.scene_name += stiff > 1 ? " (stiff)" : "";
    rewrite.text = rewritten_lighting(seed, rewrite.scene, rewrite.truth.model);
    return rewrite;
}

Diagnosis diagnosis_of(const OwnRewrite &rewrite, const DiagnosisDraw &draw, Size size) {
    Technique own = rewrite.truth;
    own.model = Model::own;
    own.own = OwnShader("own.glsl", rewrite.text);
    DiagnosisRequest request{rewrite.scene, {}, rewrite.given ? rewrite.truth : own, {}, {}};
    request.redraw = [&](const Scene &scene) { return Observed{draw.picture(scene, own, size, false).color, false}; };
    request.observed = request.redraw(rewrite.scene);
    request.trials = {changed_scenes(rewrite.scene, rewrite.scene_name)};
    return diagnose(request, draw);
}

bool is_accused(const Diagnosis &diagnosis, const OwnRewrite &rewrite) {
    const auto &look = diagnosis.after_proposal;
    return diagnosis.verdict != Verdict::right ||
           (look && std::ranges::find(look->remaining, rewrite.given ? rewrite.truth : diagnosis.technique) ==
                        look->remaining.end());
}

} // namespace sandbox
